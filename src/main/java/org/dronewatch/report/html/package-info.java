/** The HTML report: one self-contained file for a browser or for printing. */
package org.dronewatch.report.html;
