package org.dronewatch.analysis.layer;

import java.util.List;
import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessor;

/**
 * How a sensor points while it looks at a drone in a cell.
 *
 * @param towards the pointings in which the sensor may see the drone, among pointings at equal intervals of time over
 *     one period of the search; an empty element stands for the aim in the sensor's settings
 * @param passes the indices in {@code towards} at which the drone enters the field of view: in the pointing just
 *     before, it was outside
 * @param phases for each element of {@code towards}, the number of its phase of the search
 * @param share the fraction of the pointings, and so of the time, in which the sensor may see the drone, 0 to 1
 * @param away a pointing in which the sensor cannot see the drone; empty if {@code share} is 1
 */
public record CellPointings(
        List<Optional<Pointing>> towards,
        List<Integer> passes,
        List<Integer> phases,
        double share,
        Optional<Pointing> away) {

    /** A single one, at all times. */
    static CellPointings always(Optional<Pointing> pointing) {
        return new CellPointings(List.of(pointing), List.of(0), List.of(0), 1.0, Optional.empty());
    }

    /** Whether looks at a drone are certainly the same at all its headings. */
    boolean isSameAtAllHeadings(Assessor assessor, Drone there) {
        return towards.stream().allMatch(one -> assessor.isSameAtAllHeadings(there, one));
    }
}
