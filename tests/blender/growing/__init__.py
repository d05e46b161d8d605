# SPDX-License-Identifier: Apache-2.0
"""The parts of grown.py, in the order in which it calls them."""
