/** A map on paper: its frame with coordinates, its relief, its legend and its colours, whatever is on it. */
package org.dronewatch.report.sheet;
