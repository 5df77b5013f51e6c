package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.Test;

/** What is drawn depends on names: a neighbour, its place in the file and other drones change nothing. */
class DrawsByNameTest {
    private static final Position PLACE = new Position(0, 0, 30);

    private static final class Site extends FloorScene {
        private static final long serialVersionUID = 1L;

        private final transient Map<String, SensorSettings<?>> sensors;
        private final transient List<String> drones;
        private final transient Consumer<Site> more;

        Site(Map<String, SensorSettings<?>> sensors, List<String> drones, Consumer<Site> more) {
            this.sensors = sensors;
            this.drones = drones;
            this.more = more;
        }

        @Override
        protected void build() {
            loadFloor();
            for (String drone : drones) {
                double east = drone.equals("drone") ? 0 : 50 + 10 * drones.indexOf(drone);
                FlightPathSettings path = FlightPathSettings.Hover.at(new Position(east, 300, 60));
                add(drone, DroneSettings.of(loadPackaged("quadrotor.obj"), path));
            }
            sensors.forEach(this::add);
            setRun(RunSettings.DEFAULT.withDuration(8.0));
            more.accept(this);
        }
    }

    private static RadarSettings radar() {
        return RadarSettings.at(PLACE, LinkBudget.DataSheet.of(215, 0.01))
                .withSpeeds(0, 100)
                .withDetection(RadarDetection.Chance.DEFAULT);
    }

    private Map<String, List<String>> rows(List<String> sensors, List<String> drones) {
        return rows(sensors, drones, scene -> {});
    }

    /** What each sensor said of each drone, look by look, without what names or numbers the sensor. */
    private Map<String, List<String>> rows(List<String> sensors, List<String> drones, Consumer<Site> more) {
        Map<String, SensorSettings<?>> settings = new LinkedHashMap<>();
        sensors.forEach(id -> settings.put(
                id,
                switch (id.charAt(0)) {
                    case 'r' -> radar();
                    case 'm' -> AcousticSettings.at(PLACE).withRate(0.5);
                    default -> new DiceSettings(PLACE, 1.0, 0.5);
                }));
        Map<String, List<String>> rows = new LinkedHashMap<>();
        new SceneRunner(new Site(settings, drones, more))
                .onFrame(frame -> frame.observations().forEach(o -> rows.computeIfAbsent(
                                o.sensor() + " " + o.drone(), key -> new ArrayList<>())
                        .add(o.time() + " " + o.value() + " " + o.threshold() + " " + o.sighting() + o.figures())))
                .run();
        return rows;
    }

    @Test
    void anotherSensorOrderOrDroneChangesNoNumber() {
        Map<String, List<String>> alone = rows(List.of("dice", "radar", "microphone"), List.of("drone"));
        assertThat(alone).containsKeys("dice drone", "radar drone", "microphone drone");
        assertThat(alone.get("radar drone")).hasSizeGreaterThan(5).doesNotHaveDuplicates();
        Map<String, List<String>> other =
                rows(List.of("microphone", "radar-2", "extra", "radar", "dice"), List.of("guest", "drone", "third"));
        alone.forEach((pair, rows) -> assertThat(other.get(pair)).as(pair).isEqualTo(rows));
        Map<String, List<String>> switched = rows(
                List.of("extra", "dice", "radar", "microphone"), List.of("drone"), scene -> scene.disable("extra"));
        assertThat(switched).isEqualTo(alone);
    }

    @Test
    void twoSensorsAlikeAndTwoDronesAlikeDrawDifferently() {
        Map<String, List<String>> rows = rows(List.of("dice", "dice-2"), List.of("drone", "third"));
        assertThat(rows).hasSize(4);
        assertThat(rows.values()).doesNotHaveDuplicates();
    }

    @Test
    void aRunOfASweepCanBeRepeatedAloneByItsSeed() {
        Consumer<Site> swept = scene -> scene.sweep("sensors.dice.luck", 0.2, 0.4, 0.6);
        Map<Integer, List<Double>> values = new LinkedHashMap<>();
        Site sweep = new Site(Map.of("dice", new DiceSettings(PLACE, 1.0, 0.5)), List.of("drone"), swept);
        SceneResult result = new SceneRunner(sweep)
                .onFrame(frame -> frame.observations()
                        .forEach(o -> values.computeIfAbsent(frame.run(), run -> new ArrayList<>())
                                .add(o.value())))
                .run();
        long seed = result.runs().get(2).settings().run().seed();
        assertThat(result.runs().get(0).settings().run().seed()).isEqualTo(result.seed());
        assertThat(seed).isEqualTo(Draws.derivedSeed(result.seed(), "run", 2));
        List<Double> again = new ArrayList<>();
        new SceneRunner(new Site(Map.of("dice", new DiceSettings(PLACE, 1.0, 0.6)), List.of("drone"), scene -> {}))
                .seed(seed)
                .onFrame(frame -> frame.observations().forEach(o -> again.add(o.value())))
                .run();
        assertThat(again).isEqualTo(values.get(2)).isNotEqualTo(values.get(0));
    }

    /** A swept seed is taken as it is written. */
    @Test
    void sweptSeedsAreTheRuns() {
        Site sweep = new Site(
                Map.of("dice", new DiceSettings(PLACE, 1.0, 0.5)),
                List.of("drone"),
                scene -> scene.sweep("run.seed", 11, 12, 13));
        assertThat(new SceneRunner(sweep).run().runs())
                .extracting(run -> run.settings().run().seed())
                .containsExactly(11L, 12L, 13L);
    }
}
