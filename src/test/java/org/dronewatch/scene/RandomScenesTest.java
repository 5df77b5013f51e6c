package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.file.Kinds;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whatever is accepted runs to its end: every number has limits, and within them nothing breaks. */
class RandomScenesTest {
    private static final int SCENES = Integer.getInteger("dronewatch.scenes", LongForm.count(80, 600));
    private static final long SEED = Long.getLong("dronewatch.seed", 20_240_517L);
    /** Of so many scenes one runs again from its saved file. */
    private static final int SAVED_RUNS = 60;

    private static final Kinds KINDS = SensorKinds.kinds(Catalog.packaged());

    @TempDir
    private Path directory;

    /** A number without limits is one with which some scene fails that was accepted. */
    @Test
    void everyNumberOfASceneHasLimits() {
        List<String> without = new ArrayList<>();
        collect(SceneSettings.class, new HashSet<>(), without);
        assertThat(without).isEmpty();
    }

    private static void collect(Type type, Set<Type> seen, List<String> without) {
        if (!seen.add(type)) {
            return;
        }
        if (type instanceof ParameterizedType several) {
            collect(several.getRawType(), seen, without);
            for (Type inner : several.getActualTypeArguments()) {
                collect(inner, seen, without);
            }
        } else if (type instanceof Class<?> plain && KINDS.isChoice(plain)) {
            KINDS.of(plain).values().forEach(kind -> collect(kind, seen, without));
        } else if (type instanceof Class<?> plain && plain.isRecord()) {
            for (RecordComponent part : SettingsForm.of(plain).parts()) {
                boolean number = Set.of("double", "int", "java.util.List<java.lang.Double>")
                        .contains(part.getGenericType().getTypeName());
                if (number && !isBounded(part.getAnnotation(In.class))) {
                    without.add(plain.getSimpleName() + "." + part.getName());
                }
                collect(part.getGenericType(), seen, without);
            }
        }
    }

    private static boolean isBounded(In limits) {
        return limits != null
                && Double.isFinite(Math.max(limits.from(), limits.above()))
                && Double.isFinite(Math.min(limits.to(), limits.below()));
    }

    @Thorough
    @Test
    void whatIsAcceptedRunsToItsEnd() throws IOException {
        System.out.println("random scenes from seed " + SEED);
        RandomScenes.writeFiles(directory);
        Map<String, Integer> kinds = new LinkedHashMap<>();
        int accepted = 0;
        int refused = 0;
        for (long seed = SEED; accepted < SCENES; seed++) {
            String text = RandomScenes.yaml(seed);
            Path file = Files.writeString(directory.resolve("scene.yaml"), text);
            SceneRunner runner = new SceneRunner(new SceneFile(file)).threads(1).pilot(() -> RandomScenesTest::steer);
            SceneSettings read;
            try {
                read = runner.settings();
                assertThat(read).as("scene of seed %d, written and read", seed).isEqualTo(RandomScenes.of(seed));
                runner.stage(read);
            } catch (InputException e) {
                assertThat(e.getMessage()).as("seed %d", seed).contains(": ").doesNotContain("Exception");
                refused++;
                continue;
            }
            accepted++;
            run(runner, seed, text);
            checkSaved(runner, read, seed, accepted % SAVED_RUNS == 0);
            runner.settings().sensors().values().forEach(sensor -> kinds.merge(sensor.kind(), 1, Integer::sum));
        }
        assertThat(refused)
                .as("scenes refused before %d from seed %d on ran", accepted, SEED)
                .isLessThan(SCENES / 4);
        assertThat(kinds.keySet())
                .as("kinds of sensors in the scenes: %s", kinds)
                .containsExactlyInAnyOrderElementsOf(SensorKinds.all().keySet());
    }

    /** Written as a file and read again, the settings are the same; the runs of some are compared as well. */
    private void checkSaved(SceneRunner runner, SceneSettings settings, long seed, boolean runs) throws IOException {
        Path file = directory.resolve("saved.yaml");
        SceneRunner saved = new SceneRunner(new SceneFile(Files.writeString(file, runner.text(settings, file))))
                .threads(1)
                .pilot(() -> RandomScenesTest::steer);
        assertThat(saved.settings()).as("seed %d", seed).isEqualTo(settings);
        if (runs) {
            assertThat(saved.run().runs())
                    .as("seed %d", seed)
                    .isEqualTo(runner.run().runs());
        }
    }

    /** Steered drones fly east as fast as they can. */
    private static void steer(PilotedRun run) {
        run.settings().individualDrones().forEach((id, drone) -> {
            if (run.drone(id).isSteered()) {
                run.drone(id).fly(new Position(drone.speed(), 0, 0));
            }
        });
    }

    private static void run(SceneRunner runner, long seed, String text) {
        String scene = "scene of seed " + seed + ":\n" + text;
        try {
            SceneResult result = runner.onFrame(frame -> frame.observations().forEach(o -> check(o, scene)))
                    .run();
            assertThat(result.complete()).isTrue();
            result.pairs().forEach(pair -> {
                for (OptionalDouble figure : List.of(pair.firstDetected(), pair.range(), pair.maxRange())) {
                    figure.ifPresent(value -> assertThat(value).as(scene).isFinite());
                }
            });
            result.alerts().forEach(alert -> {
                for (OptionalDouble figure :
                        List.of(alert.firstSight(), alert.time(), alert.zoneDistance(), alert.warning())) {
                    figure.ifPresent(value -> assertThat(value).as(scene).isFinite());
                }
            });
        } catch (RuntimeException e) {
            throw new AssertionError(scene, e);
        }
    }

    private static void check(Observation o, String scene) {
        for (double figure : new double[] {o.time(), o.arrival()}) {
            assertThat(figure).as("%s of %s", o, scene).isFinite();
        }
        // Nothing is at no range.
        assertThat(Double.isNaN(o.range())).as("%s of %s", o, scene).isEqualTo(o.isFalse());
        assertThat(o.range()).as("%s of %s", o, scene).isNotEqualTo(Double.POSITIVE_INFINITY);
        assertThat(o.value()).as("%s of %s", o, scene).isNotNaN();
        assertThat(o.threshold()).as("%s of %s", o, scene).isNotNaN();
        o.sighting()
                .ifPresent(
                        seen -> assertThat(seen.range().orElse(0.0)).as(scene).isFinite());
    }
}
