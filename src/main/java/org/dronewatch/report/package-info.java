/** Writes the results of a run: tables, a summary and plots, either completely or not at all. */
package org.dronewatch.report;
