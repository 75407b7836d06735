"""The guide: a page per task, then pages of background.

.. include:: report.md
.. include:: cookbook.md
.. include:: weights.md
.. include:: branches.md
.. include:: repair.md
.. include:: scoring.md
.. include:: following.md
.. include:: gradients.md
.. include:: tuning.md
.. include:: batches.md
.. include:: migrating.md
.. include:: differences.md
.. include:: claims.md
.. include:: speed.md
.. include:: glossary.md
.. include:: architecture.md
"""
