"""Tests with the mark @full run in the full tier only, which sets STOKESBOOK_FULL."""

import os
import unittest

full = unittest.skipUnless(os.environ.get("STOKESBOOK_FULL"), "belongs to the full tier")
