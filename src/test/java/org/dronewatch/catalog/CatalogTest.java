package org.dronewatch.catalog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.catalog.CatalogEntry.Basis;
import org.dronewatch.catalog.CatalogEntry.PublishedRange;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every sensor of the catalogue does what its maker promises, or says that nothing is promised. */
class CatalogTest {
    private static final Position SENSOR = new Position(0, 0, 10);

    @TempDir
    private Path directory;

    private static List<String> names() {
        return Catalog.packagedNames();
    }

    @Test
    void theListHoldsEveryFile() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("src/main/resources/org/dronewatch/catalog"))) {
            assertThat(files.filter(Files::isRegularFile)
                            .map(file -> file.getFileName().toString().replace(".yaml", "")))
                    .containsExactlyInAnyOrderElementsOf(names());
        }
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyEntryHasASourceAndSaysWhatItRestsOn(String name) {
        CatalogEntry entry = Catalog.packaged().entry(name).orElseThrow();

        assertThat(entry.source()).isNotBlank();
        assertThat(entry.title()).isNotBlank();
        assertThat(SensorKinds.all()).containsKey(entry.kind());
        assertThat(entry.note())
                .contains("assumed")
                .satisfiesAnyOf(
                        note -> assertThat(entry.basis()).isEqualTo(Basis.ASSUMED),
                        note -> assertThat(entry.ranges()).isNotEmpty());
        assertThat(entry.note().contains("No range")).isEqualTo(entry.ranges().isEmpty());
        SensorSettings<?> settings = Catalog.packaged().settings(name, Map.of("position", SENSOR));
        assertThat(settings.position()).isEqualTo(SENSOR);
        assertThat(settings.kind()).isEqualTo(entry.kind());
    }

    @ParameterizedTest
    @MethodSource("names")
    void noEntryPromisesWhatPhysicsForbids(String name) {
        assertThat(Catalog.packaged().settings(name, Map.of("position", SENSOR)).advice())
                .isEmpty();
    }

    @ParameterizedTest
    @MethodSource("names")
    void aSensorIsKnownByItsSettingsWhereverItStands(String name) {
        SensorSettings<?> settings = Catalog.packaged().settings(name, Map.of("position", new Position(7, 8, 9)));

        // Its data sheet has the same figures for both: nothing tells one from the other.
        assertThat(Catalog.nameOf(settings)).contains(name.equals("spotterrf-c550ext") ? "spotterrf-c550" : name);
    }

    @Test
    void aSensorOfOtherSettingsIsNotInTheCatalogue() {
        SensorSettings<?> radar =
                Catalog.packaged().settings("spotterrf-c550", Map.of("position", SENSOR, "maxRange", 900.0));

        assertThat(Catalog.nameOf(radar)).isEmpty();
    }

    /** One sensor and one drone that comes straight at it over flat grass. */
    private static final class Promise extends Scene {
        private static final long serialVersionUID = 1L;

        private final transient String name;
        private final transient PublishedRange range;

        Promise(String name, PublishedRange range) {
            this.name = name;
            this.range = range;
        }

        @Override
        protected void build() {
            WorldSettings world = range.worldOf(ModelSettings.of("grass.obj"));
            loadWorld(world.models().get(0));
            setBackgroundNoise(world.noise());
            surface("grass", "grass_turf");
            Position far = SENSOR.plus(new Position(0, 1.2 * range.distance(), 0));
            Position near = SENSOR.plus(new Position(0, 0.8 * range.distance(), 0));
            SensorSettings<?> there = Catalog.packaged().settings(name, Map.of("position", SENSOR));
            SensorSettings<?> sensor = there.as(Aimed.class)
                    .<SensorSettings<?>>map(aimed -> aimed.withAim(new Aim.Target(far)))
                    .orElse(there);
            DroneSettings drone = range.droneOn(new Approach(far, near));
            double speed = Math.min(40.0, 0.004 * range.distance() * sensor.rate());
            add("drone", drone.withSpeed(speed));
            add("sensor", sensor);
            setRun(RunSettings.DEFAULT.withDuration(0.39 * range.distance() / speed));
        }
    }

    /** Of sensors that measure in decibels; {@link CatalogCameraTest} has the others. */
    private static List<Object[]> promises() {
        List<Object[]> all = new ArrayList<>();
        for (String name : names()) {
            if (CatalogCameraTest.KINDS.contains(
                    Catalog.packaged().entry(name).orElseThrow().kind())) {
                continue;
            }
            for (PublishedRange range :
                    Catalog.packaged().entry(name).orElseThrow().ranges()) {
                all.add(new Object[] {name, range});
            }
        }
        return all;
    }

    @ParameterizedTest
    @MethodSource("promises")
    void atThePublishedRangeTheThresholdIsJustMet(String name, PublishedRange range) throws IOException {
        Files.writeString(directory.resolve("grass.mtl"), "newmtl grass\n");
        Files.writeString(
                directory.resolve("grass.obj"),
                "mtllib grass.mtl\nusemtl grass\nv -20000 0 -20000\nv 20000 0 -20000\nv 20000 0 20000\nv -20000 0 20000\n"
                        + "f 1 3 2\nf 1 4 3\n");
        List<Observation> seen = new ArrayList<>();
        new SceneRunner(new Promise(name, range))
                .directory(directory)
                .onFrame(frame -> seen.addAll(frame.observations()))
                .run();

        Optional<Observation> first =
                seen.stream().filter(Observation::isDetected).findFirst();
        assertThat(first).as("%s, nearest %s", name, seen.get(seen.size() - 1)).isPresent();
        Observation met = first.get();
        assertThat(met.range())
                .as("first detected: %s", met)
                .isCloseTo(range.distance(), within(0.05 * range.distance()));
        assertThat(seen.get(0).isDetected())
                .as("an instrumented range alone is no promise: %s", seen.get(0))
                .isFalse();
        assertThat(seen.get(0).value()).as("measured before it is detected").isFinite();
        assertThat(met.unit()).as("0.9 of it means 0.9 dB").startsWith("dB");
        Observation at = seen.stream()
                .min((a, b) ->
                        Double.compare(Math.abs(a.range() - range.distance()), Math.abs(b.range() - range.distance())))
                .orElseThrow();
        assertThat(at.value()).as("at the published range: %s", at).isCloseTo(at.threshold(), within(0.9));
    }

    @Test
    void onlyTheNamesAreGivenAndEveryPartMayBeChanged() {
        RadarSettings radar = (RadarSettings) Catalog.packaged()
                .settings("blighter-a400", Map.of("position", SENSOR, "rate", 2.0, "aim", new Aim.Direction(1, 0)));

        assertThat(radar.rate()).isEqualTo(2.0);
        assertThat(radar.aim()).isEqualTo(new Aim.Direction(1, 0));
        assertThat(radar.maxRange()).isEqualTo(10_000.0);
        assertThat(radar.budget())
                .isEqualTo(LinkBudget.DataSheet.of(8000, 0.01).withGain(37.5).withIntegrationTime(0.02));
    }

    @Test
    void aFileBesideTheSceneIsASensor() throws IOException {
        Files.writeString(
                directory.resolve("my-radar.yaml"),
                """
                title: my radar
                source: measured on 3 May
                basis: calibrated
                coverage: all round
                ranges: [{distance: 900, target: 0.1 m2}]
                sensor:
                  kind: radar
                  budget: {kind: data-sheet, range: 900, crossSection: 0.1}
                """);
        Files.writeString(
                directory.resolve("site.yaml"),
                """
                world: {models: [packaged:hill.obj]}
                sensors:
                  mine: {use: my-radar, position: [1, 2, 3], budget: {range: 800 m}}
                  theirs: {use: spotterrf-c550, position: [1, 2, 3], rate: 1, detection: {kind: chance}}
                """);
        Map<String, SensorSettings<?>> sensors =
                new SceneFile(directory.resolve("site.yaml")).describe().sensors();

        RadarSettings mine = (RadarSettings) sensors.get("mine");
        assertThat(mine.budget()).isEqualTo(LinkBudget.DataSheet.of(800, 0.1));
        assertThat(((RadarSettings) sensors.get("theirs")).rate()).isEqualTo(1.0);
        assertThat(((RadarSettings) sensors.get("theirs")).maxRange()).isEqualTo(1500.0);
        assertThat(((RadarSettings) sensors.get("theirs")).detection()).isEqualTo(RadarDetection.Chance.DEFAULT);
    }

    @Test
    void aMistypedNameIsAnsweredWithTheNearest() throws IOException {
        Path file = directory.resolve("site.yaml");
        Files.writeString(
                file,
                "world: {models: [packaged:hill.obj]}\nsensors: {a: {use: bligther-a400, position: [1, 2, 3]}}\n");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneFile(file).describe())
                .withMessageContaining(
                        ":2:20: sensors.a.use: unknown name 'bligther-a400'; did you mean 'blighter-a400'?");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> Catalog.packaged().settings("../secret", Map.of()))
                .withMessageContaining("no sensor '../secret'");
    }
}
