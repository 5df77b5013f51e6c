/** The page of one run: a class for each of its sections, tables and figures. */
package org.dronewatch.report.html.run;
