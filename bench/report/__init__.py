"""graze-report: measures graze beside its peers and writes a page. Modules are imported from the
package (`from report import figures, page, statistics`), since one of them has the name of a module
of the standard library."""
