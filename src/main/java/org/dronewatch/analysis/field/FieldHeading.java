package org.dronewatch.analysis.field;

import java.util.List;
import java.util.Locale;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/** Which heading of the drone counts in a cell. */
public enum FieldHeading {
    /** The heading on which the sensors together are least likely to detect the drone. */
    WORST,
    /** The heading on which the sensors together are most likely to detect the drone. */
    BEST,
    /**
     * Towards the centre of the grid's area or, if it has none, the centre of the protected zone; without either,
     * towards the mean position of the sensors.
     */
    INBOUND;

    /**
     * The courses of a drone that have to be assessed.
     *
     * @param drone name of the drone
     * @throws IllegalArgumentException when there is no such drone
     */
    public List<Course> courses(SceneSettings settings, Stage stage, String drone, FieldGrid grid) {
        return this == INBOUND
                ? List.of(Course.inbound(InboundTarget.of(settings, stage.protection(), grid)))
                : Course.all(settings.enabledSensors(), DetectionField.droneOf(stage, drone));
    }

    /**
     * The courses under a condition: inbound drones keep their target even if the condition moves the mean position of
     * the sensors by switching one off.
     *
     * @param asItIs the request for the scene as it is
     * @param settings the settings under the condition
     * @param stage the stage under the condition
     */
    public List<Course> coursesUnder(FieldRequest asItIs, SceneSettings settings, Stage stage) {
        return this == INBOUND ? asItIs.courses() : courses(settings, stage, asItIs.drone(), asItIs.grid());
    }

    /** Which of the courses counts. */
    public FieldCoverage.Choice choice() {
        return this == BEST ? FieldCoverage.Choice.BEST : FieldCoverage.Choice.WORST;
    }

    /** The name of this heading in options and files, such as {@code worst}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
