package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.assertj.core.data.Offset;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.Swarm;
import org.dronewatch.flight.Swarm.Formation;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.Ground;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SwarmTest {
    private static final Offset<Double> EXACT = within(1e-9);
    private static final DroneSettings ONE = DroneSettings.of(
            ModelSettings.packaged("quadrotor.obj"), new Approach(new Position(0, 300, 150), new Position(0, 0, 150)));

    @TempDir
    private Path directory;

    private static SceneSettings scene(Map<String, DroneSettings> drones) {
        SceneSettings empty = SceneSettings.of(WorldSettings.of(ModelSettings.packaged("hill.obj")));
        return new SceneSettings(
                empty.world(),
                drones,
                empty.sensors(),
                empty.disabled(),
                empty.alert(),
                empty.prices(),
                empty.run(),
                empty.sweep());
    }

    private SceneRunner runner() throws IOException {
        Path file = directory.resolve("swarm.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  lone:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [2, 6, 144.5]}
                  x:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [0, 20, 145], to: [0, 4, 144.5]}
                    swarm: {count: 2, spacing: 2 m, formation: wedge}
                sensors:
                  eye: {kind: camera, position: [0, 0, 144], width: 320, height: 180}
                run: {duration: 4}
                """);
        return new SceneRunner(new SceneFile(file));
    }

    /** The nearest other drone is one spacing away, for each drone in each formation, all the time. */
    @ParameterizedTest
    @EnumSource(Formation.class)
    void neighboursFlyOneSpacingApart(Formation formation) {
        DroneSettings swarm = ONE.withSwarm(new Swarm(11, 2.5, formation));
        List<FlightPath> paths = swarm.members().stream()
                .map(flier -> flier.createFlight(Ground.NONE))
                .toList();
        FlightPath leader = ONE.createFlight(Ground.NONE);

        assertThat(paths).hasSize(11);
        for (double time = 0.0; time < 70.0; time += 7.0) {
            assertThat(paths.get(0).at(time)).isEqualTo(leader.at(time));
            for (FlightPath path : paths) {
                double nearest = Double.POSITIVE_INFINITY;
                for (FlightPath other : paths) {
                    if (other != path) {
                        Position place = other.at(time).position();
                        nearest = Math.min(nearest, path.at(time).position().distance(place));
                    }
                }
                assertThat(nearest).isCloseTo(2.5, EXACT);
                assertThat(path.at(time).velocity()).isEqualTo(leader.at(time).velocity());
            }
        }
    }

    /** The leader flies south: its right is west. */
    @Test
    void formationsAreThoseOfTheLeadersHeading() {
        assertThat(places(Formation.LINE, 3)).containsExactly(at(0, 300, 0), at(-10, 300, 0), at(10, 300, 0));
        assertThat(places(Formation.COLUMN, 3)).containsExactly(at(0, 300, 0), at(0, 310, 0), at(0, 320, 0));
        assertThat(places(Formation.WEDGE, 3))
                .containsExactly(at(0, 300, 0), at(-7.07, 307.07, 0), at(7.07, 307.07, 0));
        assertThat(places(Formation.GRID, 4))
                .containsExactly(at(0, 300, 0), at(-10, 300, 0), at(0, 310, 0), at(-10, 310, 0));
        assertThat(places(Formation.STACK, 2)).containsExactly(at(0, 300, 0), at(0, 300, 10));
    }

    private static List<String> places(Formation formation, int count) {
        List<String> places = new ArrayList<>();
        for (DroneSettings flier :
                ONE.withSwarm(new Swarm(count, 10, formation)).members()) {
            Position place = flier.createFlight(Ground.NONE).at(0.0).position();
            places.add(at(place.x(), place.y(), place.z() - 150));
        }
        return places;
    }

    private static String at(double x, double y, double z) {
        return String.format("%.2f %.2f %.2f", x, y, z).replace("-0.00", "0.00");
    }

    @Test
    void eachDroneOfASwarmIsDetectedByItself() throws IOException {
        SceneResult result = runner().run();

        assertThat(result.pairs()).extracting(PairResult::drone).containsExactly("lone", "x-1", "x-2");
        for (String drone : List.of("lone", "x-1", "x-2")) {
            assertThat(result.firstDetectionRange("eye", drone)).as(drone).isPresent();
        }
    }

    @Test
    void overridesAndSweepsChangeTheSwarm() throws IOException {
        SceneSettings three = runner().set("drones.x.swarm.count", "3").settings();
        assertThat(three.drones()).containsOnlyKeys("lone", "x");
        assertThat(three.individualDrones().keySet()).containsExactly("lone", "x-1", "x-2", "x-3");
        assertThat(three.individualDrones().get("x-3").swarm()).isEmpty();
        assertThat(runner().set("drones.lone.swarm", "4").settings().individualDrones())
                .hasSize(6);

        Files.writeString(
                directory.resolve("swept.yaml"),
                Files.readString(directory.resolve("swarm.yaml"))
                        + "sweep: {parameter: drones.x.swarm.count, values: [1, 5]}\n");
        SceneResult swept = new SceneRunner(new SceneFile(directory.resolve("swept.yaml"))).run();
        assertThat(swept.runs()).extracting(run -> run.pairs().size()).containsExactly(2, 6);
    }

    @Test
    void aSwarmFliesOverTheGroundThatItsLeaderFollows() throws IOException {
        SceneRunner runner = runner();
        Path file = directory.resolve("low.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  low:
                    model: packaged:quadrotor.obj
                    flight: {kind: low-approach, target: [0, 0], distance: 600, height: 10}
                    swarm: {count: 1000, spacing: 0.5, formation: column}
                """);
        SceneRunner low = new SceneRunner(new SceneFile(file));
        List<Drone> drones = low.stage(low.settings()).dronesAt(10.0);

        assertThat(drones).hasSize(1000);
        assertThat(drones.get(999).position().y - drones.get(0).position().y).isCloseTo(499.5, EXACT);
        assertThat(drones.get(999).position().z).isEqualTo(drones.get(0).position().z);

        low.set("drones.low.flight.target.x", "9000");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> low.stage(low.settings()))
                .withMessage(
                        "drone 'low-1': flight: there is no ground anywhere below the path of 600.0 m for the drone"
                                + " to follow");
        assertThat(runner.settings().individualDrones()).hasSize(3);
    }

    @Test
    void whatCannotFlyTogetherIsRefused() {
        Map<String, DroneSettings> same = new LinkedHashMap<>();
        same.put("a", ONE.withSwarm(Swarm.of(3)));
        same.put("a-2", ONE.withFlight(Hover.at(new Position(0, 0, 200))));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> scene(same))
                .withMessage(
                        "drones 'a' and 'a-2' both produce a drone 'a-2', since the drones of a swarm are numbered: rename"
                                + " one");

        Map<String, DroneSettings> many = new LinkedHashMap<>();
        many.put("a", ONE.withSwarm(Swarm.of(600)));
        many.put("b", ONE.withSwarm(Swarm.of(401)));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> scene(many))
                .withMessage("drones: 1001 in all, including swarms; there must be at most 1000");

        assertThatIllegalArgumentException()
                .isThrownBy(() -> Swarm.of(1001))
                .withMessage("count 1001 must be 1 to 1000");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Swarm(2, 0, Formation.LINE))
                .withMessage("spacing 0 m must be above 0 and at most 10000");
    }
}
