/** The report for people: one file that holds all it shows, for a browser or for paper. */
package org.dronewatch.report.html;
