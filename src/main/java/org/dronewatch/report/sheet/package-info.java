/** A map sheet: its scale bar and north arrow, its relief, its legend and its colours, whatever it shows. */
package org.dronewatch.report.sheet;
