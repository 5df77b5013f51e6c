package org.dronewatch.placement.site;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;

/** All candidates of a plan as sensors of one scene, whose field says which of them cover each cell. */
final class CandidateField {
    private CandidateField() {}

    /** The field on eight compass headings. */
    static DetectionField of(PlacePlan plan, FieldGrid grid) {
        Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
        plan.candidates().forEach(one -> sensors.put(one.name(), one.sensor()));
        Stage stage = plan.runner().stage(plan.present());
        var scene = SettingsForm.with(plan.present(), Map.of("sensors", sensors, "disabled", Set.of()));
        List<Course> courses = Course.all(Map.of(), DetectionField.droneOf(stage, FieldSite.DRONE))
                .subList(0, 8);
        return FieldAssessment.of(scene, stage, FieldSite.DRONE, grid, courses, cells -> {});
    }
}
