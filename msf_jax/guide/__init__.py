"""A page per task.

.. include:: report.md
.. include:: weights.md
.. include:: repair.md
.. include:: scoring.md
.. include:: following.md
.. include:: gradients.md
.. include:: tuning.md
.. include:: batches.md
.. include:: migrating.md
"""
