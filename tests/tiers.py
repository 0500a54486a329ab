"""Which tests run: those with the mark @full belong to the full tier, which sets STOKESBOOK_FULL."""

import os
import unittest

full = unittest.skipUnless(os.environ.get("STOKESBOOK_FULL"), "belongs to the full tier")
