package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Of real scenes: another sensor never lowers the least exposure, and neither the order of the sensors nor the number
 * of threads changes a bit of the routes.
 */
class RouteInvarianceTest {
    private record Site(String scene, String drone, double side, double cell) {}

    private static final String MICROPHONE = "microphone";

    /** A radar that looks every five seconds, and an observer. */
    private static final String SLOW =
            """
              slow: {kind: radar, position: [-20, 5, 4], rate: 0.2, minRange: 1, maxRange: 300, elevationWidth: 90 deg,
                budget: {range: 90, crossSection: 0.01}, minSpeed: 0 m/s, detection: {kind: chance, pulses: 8}}
              observer: {kind: camera, position: [0, 3, 4], fov: 60 deg, width: 640, height: 480, rate: 25,
                detection: {kind: target-task, task: detection, byChance: true}}
            """;

    private static final String ZONE = "{protect: {centre: [0, 0, 10], radius: 25}, response: 3 s}\n";

    private static final List<Double> HEIGHTS = List.of(10.0, 30.0, 60.0, 120.0);

    static List<Site> sites() {
        return LongForm.IS_ON
                ? List.of(
                        new Site("cued-camera", "intruder", 800, 40),
                        new Site("palace", "intruder", 2000, 40),
                        new Site("glider", "glider", 1000, 50),
                        new Site("monaco", "from-the-sea", 2400, 80))
                : List.of(new Site("meadow", "intruder", 2400, 200));
    }

    private static SiteRoutes routes(DetectionField field, SceneSettings settings, Stage stage, Site site) {
        return SiteRoutes.of(field, settings, stage, site.drone());
    }

    private static DetectionField field(SceneSettings settings, Stage stage, Site site, int threads) {
        Position middle = InboundTarget.of(settings, stage.protection());
        FieldGrid grid = new FieldGrid(middle.x(), middle.y(), site.side(), site.cell(), HEIGHTS);
        List<Course> courses = Course.all(settings.enabledSensors(), DetectionField.droneOf(stage, site.drone()));
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> FieldAssessment.of(settings, stage, site.drone(), grid, courses, cells -> {}));
        }
    }

    @Thorough
    @ParameterizedTest
    @MethodSource("sites")
    void sensorsAddUpInAnyOrderOnAnyThreads(Site site) {
        SceneRunner runner =
                new SceneRunner(new SceneFile(Path.of("scenes/" + site.scene() + ".yaml"))).notes(note -> {});
        SceneSettings scene = runner.settingsOfRuns().get(0);
        // Each look of a microphone takes up to a tenth of a second.
        SceneSettings settings = scene.sensors().containsKey(MICROPHONE) ? scene.withEnabled(MICROPHONE, false) : scene;
        Stage stage = runner.stage(settings);
        assertInvariant(settings, stage, site);
    }

    /** Of every kind, on a positioner, by chance in each look and in each encounter, often and every five seconds. */
    @Thorough
    @Test
    void sensorsOfEveryKindAddUp(@TempDir Path directory) throws IOException {
        FieldSite site = FieldSite.in(directory, FieldSite.ALL + SLOW + "alert: " + ZONE);

        assertInvariant(
                site.settings(), site.stage(), new Site("every kind", FieldSite.DRONE, 400, LongForm.IS_ON ? 20 : 80));
    }

    private static void assertInvariant(SceneSettings settings, Stage stage, Site site) {
        DetectionField field = field(settings, stage, site, 1);
        SiteRoutes all = routes(field, settings, stage, site);
        boolean isExposed = false;
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            isExposed |= all.overNodes(sector) > 0.0;
        }
        assertThat(isExposed).isTrue();

        for (String sensor : field.sensors()) {
            SceneSettings fewer = settings.withEnabled(sensor, false);
            SiteRoutes others = routes(field.without(sensor), fewer, stage, site);
            for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
                assertThat(all.overNodes(sector))
                        .as("%s without %s, sector %d", site, sensor, sector)
                        .isGreaterThanOrEqualTo(others.overNodes(sector));
            }
        }
        SceneSettings reversed = reversed(settings);
        SiteRoutes again = routes(field(reversed, stage, site, 3), reversed, stage, site);
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            WeakestRoute route = all.from(sector).orElseThrow();
            assertThat(again.from(sector)).contains(route);
            assertThat(again.bySensor(route)).isEqualTo(all.bySensor(route));
        }
    }

    private static SceneSettings reversed(SceneSettings settings) {
        List<String> names = new ArrayList<>(settings.sensors().keySet());
        Collections.reverse(names);
        Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
        names.forEach(name -> sensors.put(name, settings.sensors().get(name)));
        return SettingsForm.with(settings, "sensors", sensors);
    }
}
