/** Map sheets, whatever they show: scale bar and north arrow, relief, legend and colours. */
package org.dronewatch.report.sheet;
