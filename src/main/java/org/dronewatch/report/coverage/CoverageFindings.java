package org.dronewatch.report.coverage;

import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.FieldSummary;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.VisibleHeights;

/**
 * What {@code coverage} has found.
 *
 * @param summary the coverage, cell by cell and in numbers
 * @param visible the least visible heights
 * @param detectable the least heights at which a sensor detects the drone
 * @param warnings the warning of inbound flights
 */
public record CoverageFindings(
        FieldSummary summary, VisibleHeights visible, DetectableHeights detectable, InboundWarnings warnings) {}
