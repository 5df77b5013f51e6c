/** Writes what a run gave: tables, a summary and plots, whole or not at all. */
package org.dronewatch.report;
