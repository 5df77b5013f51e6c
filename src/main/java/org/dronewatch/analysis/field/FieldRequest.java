package org.dronewatch.analysis.field;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.layer.ExcessSurvey;
import org.dronewatch.analysis.layer.FieldProbe;
import org.dronewatch.drone.Drone;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/**
 * A request for a {@code FieldSurvey}.
 *
 * @param settings settings of one run
 * @param stage world and drones of that run
 * @param drone name of the drone that is put into the cells
 * @param grid the cells
 * @param courses courses on which the drone flies, at least one
 * @param choice which of the courses counts
 * @param terms terms on which the drone counts as detected
 * @param covered the probability with which a sensor must detect the drone to cover a cell, 0.008 to 0.996, or 1
 */
public record FieldRequest(
        SceneSettings settings,
        Stage stage,
        String drone,
        FieldGrid grid,
        List<Course> courses,
        FieldCoverage.Choice choice,
        FieldTerms terms,
        double covered) {
    /**
     * Copies the list: later changes by the caller have no effect.
     *
     * @throws IllegalArgumentException as for {@link FieldCoverage#checkedProbability}
     */
    public FieldRequest {
        FieldCoverage.checkedProbability(covered);
        courses = List.copyOf(courses);
    }

    /** The drone whose coverage is assessed unless another is named: the first, or the first bird if all are birds. */
    public static Optional<String> firstDrone(SceneSettings settings) {
        Set<String> all = settings.individualDrones().keySet();
        return all.stream()
                .filter(id -> !settings.birds().contains(id))
                .findFirst()
                .or(() -> all.stream().findFirst());
    }

    /**
     * The sensors that another request lacks because they are switched off there; empty if the other request differs
     * from this one in anything else.
     */
    public Optional<Set<String>> switchedOffIn(FieldRequest other) {
        Set<String> off = new LinkedHashSet<>(settings.enabledSensors().keySet());
        off.removeAll(other.settings.enabledSensors().keySet());
        boolean isSame = settings.world().equals(other.settings.world())
                && settings.drones().equals(other.settings.drones())
                && settings.sensors().equals(other.settings.sensors())
                && settings.run().equals(other.settings.run())
                && other.settings.disabled().containsAll(settings.disabled())
                && drone.equals(other.drone)
                && grid.equals(other.grid)
                && terms.equals(other.terms);
        return isSame ? Optional.of(off) : Optional.empty();
    }

    /**
     * The number of cells that the sensors look at for the field itself, not counting those for detectable heights and
     * inbound flights, added up over all sensors. The cells of a sensor whose signal may be interpolated count twice:
     * once for the assessment, and once for tracing the levels to be interpolated, which takes most of the time.
     */
    public long looksOfField() {
        long sensors = settings.enabledSensors().size() + surveys();
        return sensors * grid.cells() * grid.heights().size();
    }

    private long surveys() {
        Drone sample = DetectionField.droneOf(stage, drone);
        return settings.enabledSensors().entrySet().stream()
                .filter(one -> ExcessSurvey.isPossible(new FieldProbe(
                        stage.world(),
                        sample,
                        one.getKey(),
                        one.getValue(),
                        settings.run().seed(),
                        courses,
                        FieldTerms.ONE_LOOK)))
                .count();
    }

    /** The approximate number of cells that the sensors look at for the whole survey, added up over all sensors. */
    public long looks() {
        InboundFlights flights = InboundFlights.of(settings, stage, drone, grid, terms);
        long cells = (long) grid.cells() * DetectableHeights.rounds(grid)
                + (long) flights.steps()
                        * InboundFlights.BEARINGS
                        * grid.heights().size();
        return looksOfField() + cells * settings.enabledSensors().size();
    }
}
