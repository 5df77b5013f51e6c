package org.dronewatch.analysis.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.CellCode;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.cell.MarginCode;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.store.SiteStore;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.input.FileHash;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A survey that finds former assessments is the same as one without them, whatever happens to the files meanwhile. */
class LayerStoreTest {
    private static final FieldGrid GRID = new FieldGrid(3, 2, 240, 20, List.of(2.0, 14.0));

    /** A radar with chance on many courses, one that decides sharply, and a receiver. */
    private static final String SENSORS = FieldSite.ROUND
            + """
              notched: {kind: radar, position: [5, 0, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg,
                budget: {range: 120, crossSection: 0.01}, notch: {kind: high-pass, halfPowerSpeed: 4 m/s},
                detection: {kind: chance, pulses: 8}}
              radio: {kind: rf, position: [0, 5, 4], threshold: 45}
            """;

    @TempDir
    private static Path scene;

    private static FieldSite site;
    private static String expected;

    @TempDir
    private Path place;

    private final List<String> notes = new ArrayList<>();

    @BeforeAll
    static void withoutStore() throws IOException {
        site = FieldSite.in(scene, SENSORS);
        expected = text(survey(site, GRID, 0.5, LayerStore.NONE, 2));
    }

    private static FieldSurvey survey(FieldSite of, FieldGrid grid, double covered, LayerStore store, int threads) {
        FieldRequest request = new FieldRequest(
                of.settings(),
                of.stage(),
                FieldSite.DRONE,
                grid,
                Course.all(of.settings().enabledSensors(), DetectionField.droneOf(of.stage(), FieldSite.DRONE)),
                FieldCoverage.Choice.BEST,
                FieldTerms.ONE_LOOK,
                covered);
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> FieldSurvey.of(request, List.of(), settings -> store, cells -> {}, () -> {}));
        }
    }

    /** Everything that follows from the assessments. */
    private static String text(FieldSurvey survey) {
        StringBuilder text = new StringBuilder();
        DetectionField field = survey.summary().coverage().field();
        for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
            for (int height = 0; height < field.grid().heights().size(); height++) {
                for (int cell = 0; cell < field.grid().cells(); cell++) {
                    for (int course = 0; course < field.courses().size(); course++) {
                        int column = cell % field.grid().columns();
                        int row = cell / field.grid().columns();
                        text.append(field.step(sensor, height, column, row, course))
                                .append(field.cause(sensor, height, column, row, course))
                                .append(field.margin(sensor, height, column, row, course));
                    }
                }
            }
        }
        for (int cell = 0; cell < field.grid().cells(); cell++) {
            text.append(survey.detectable()
                    .orElseThrow()
                    .height(cell % field.grid().columns(), cell / field.grid().columns()));
        }
        return text.append(survey.warnings().orElseThrow()).toString();
    }

    private LayerStore store(FieldSite of, Map<String, List<FileHash>> files) {
        SiteStore kept = new SiteStore(Optional.of(place), 1 << 28, 0.0, notes::add);
        return LayerStore.of(of.settings(), files, kept);
    }

    private LayerStore store() {
        return store(site, Map.of("plain.obj", List.of(new FileHash("plain.obj", "ab"))));
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> all = Files.list(place)) {
            return all.sorted().toList();
        }
    }

    private static Map<Path, byte[]> contents(List<Path> files) throws IOException {
        Map<Path, byte[]> contents = new java.util.LinkedHashMap<>();
        for (Path file : files) {
            contents.put(file, Files.readAllBytes(file));
        }
        return contents;
    }

    @Test
    void theSecondSurveyFindsWhatTheFirstAssessed() throws IOException {
        assertThat(text(survey(site, GRID, 0.5, store(), 3))).isEqualTo(expected);
        List<Path> kept = files();
        // Three sensors at two heights, in five rounds and on two heights of inbound flights.
        assertThat(kept).hasSize(3 * (2 + DetectableHeights.rounds(GRID) + 2));
        for (Path file : kept) {
            Files.setLastModifiedTime(file, java.nio.file.attribute.FileTime.fromMillis(0));
        }
        Map<Path, byte[]> before = contents(kept);
        assertThat(text(survey(site, GRID, 0.5, store(), 1))).isEqualTo(expected);
        assertThat(contents(files())).hasSameSizeAs(before);
        for (Path file : kept) {
            assertThat(file).as("taken, not written").hasBinaryContent(before.get(file));
            assertThat(Files.getLastModifiedTime(file).toMillis()).as("used").isPositive();
        }
    }

    /** What is kept does not depend on the probability that is asked for, only the search for heights does. */
    @Test
    void anotherProbabilityAssessesFewCellsAnew() throws IOException {
        survey(site, GRID, 0.5, store(), 2);
        Map<Path, byte[]> before = contents(files());
        FieldSurvey again = survey(site, GRID, 0.9, store(), 2);
        assertThat(text(again)).isEqualTo(text(survey(site, GRID, 0.9, LayerStore.NONE, 2)));
        AtomicInteger changed = new AtomicInteger();
        for (Map.Entry<Path, byte[]> file : contents(files()).entrySet()) {
            assertThat(before).containsKey(file.getKey());
            changed.addAndGet(java.util.Arrays.equals(file.getValue(), before.get(file.getKey())) ? 0 : 1);
        }
        assertThat(changed.get()).isLessThanOrEqualTo(3 * DetectableHeights.rounds(GRID));
    }

    /** While heights are searched, a microphone only finds out whether it reaches one probability: no other one. */
    @Thorough
    @Test
    void whatIsKeptForOneProbabilityIsNotTakenForAnother() throws IOException {
        FieldSite ears = FieldSite.in(
                Files.createDirectory(scene.resolve("ears")),
                """
                  ear: {kind: acoustic, position: [0, 0, 4],
                    propagation: {kind: level-model, initialRays: 3, reflectionsPerHit: 4, maxOrder: 2, attenuation: 0.01}}
                """);
        FieldGrid near = new FieldGrid(0.7, 110.3, 80, 10, List.of(2.0, 40.0));
        String half = text(survey(ears, near, 0.5, LayerStore.NONE, 2));
        String most = text(survey(ears, near, 0.9, LayerStore.NONE, 2));
        assertThat(most).isNotEqualTo(half);
        LayerStore store = store(ears, Map.of("plain.obj", List.of(new FileHash("plain.obj", "ab"))));
        assertThat(text(survey(ears, near, 0.5, store, 2))).isEqualTo(half);
        assertThat(text(survey(ears, near, 0.9, store, 2))).isEqualTo(most);
        assertThat(text(survey(ears, near, 0.5, store, 1))).isEqualTo(half);
    }

    /** Whatever the assessments depend on changes their names. */
    @Test
    void whatDependsOnSomethingElseIsAssessedAnew() throws IOException {
        survey(site, GRID, 0.5, store(), 2);
        int count = files().size();
        FieldSite louder = FieldSite.in(
                Files.createDirectory(scene.resolve("louder")), SENSORS.replace("threshold: 45", "threshold: 46"));
        survey(louder, GRID, 0.5, store(louder, Map.of("plain.obj", List.of(new FileHash("plain.obj", "ab")))), 2);
        assertThat(files()).as("one sensor alone").hasSize(count + count / 3);
        survey(site, GRID, 0.5, store(site, Map.of("plain.obj", List.of(new FileHash("plain.obj", "cd")))), 2);
        assertThat(files()).as("another file").hasSize(2 * count + count / 3);
        FieldGrid other = new FieldGrid(3, 2, 240, 40, List.of(2.0, 14.0));
        assertThat(text(survey(site, other, 0.5, store(), 2)))
                .isEqualTo(text(survey(site, other, 0.5, LayerStore.NONE, 2)));
    }

    /** Flipped bits, cut ends, and files of nothing: all are assessed anew, with the same result. */
    @Test
    void damagedFilesAreAssessedAnew() throws IOException {
        survey(site, GRID, 0.5, store(), 2);
        long seed = 27;
        SplittableRandom random = new SplittableRandom(seed);
        Map<Path, byte[]> sound = contents(files());
        for (int i = 0; i < 3; i++) {
            for (Map.Entry<Path, byte[]> file : sound.entrySet()) {
                byte[] bytes = file.getValue().clone();
                switch (random.nextInt(4)) {
                    case 0 -> bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
                    case 1 -> bytes = java.util.Arrays.copyOf(bytes, random.nextInt(bytes.length));
                    case 2 -> bytes = java.util.Arrays.copyOf(bytes, bytes.length + 1 + random.nextInt(9));
                    default -> bytes = new byte[0];
                }
                Files.write(file.getKey(), bytes);
            }
            assertThat(text(survey(site, GRID, 0.5, store(), 2)))
                    .as("seed %d, time %d", seed, i)
                    .isEqualTo(expected);
            for (Map.Entry<Path, byte[]> file : sound.entrySet()) {
                assertThat(file.getKey()).as("written anew").hasBinaryContent(file.getValue());
            }
        }
        assertThat(notes).isEmpty();
    }

    /** Slices that have the right checksum, but were not made by this program. */
    @Test
    void impossibleSlicesAreRefused() {
        double[] z = {4.0, Double.NaN};
        int code = CellCode.of(ProbabilityStep.CERTAIN, Cause.DETECTED, MarginCode.of(-3.2));
        byte[] pool = new byte[CourseCodes.most(2)];
        CourseCodes.put(pool, 0, new int[] {code, CellCode.of(10, Cause.TOO_WEAK, MarginCode.NO_SIGNAL)});
        new LayerSlice(2, z, new int[][] {{-1, code}}, new byte[][] {pool}).check(2, 1, 2);
        byte[] cut = java.util.Arrays.copyOf(pool, pool.length - 1);
        List<LayerSlice> hostile = new ArrayList<>(List.of(
                new LayerSlice(3, z, new int[][] {{0, 0}}, new byte[][] {pool}),
                new LayerSlice(2, new double[3], new int[][] {{0, 0}}, new byte[][] {pool}),
                new LayerSlice(2, z, new int[][] {{0, 0, 0}}, new byte[][] {pool}),
                new LayerSlice(2, z, new int[][] {{0, 0}, {0, 0}}, new byte[][] {pool, pool}),
                new LayerSlice(2, z, new int[][] {{12 << 8, 0}}, new byte[][] {pool}),
                new LayerSlice(2, z, new int[][] {{1 << 24, 0}}, new byte[][] {pool}),
                new LayerSlice(2, z, new int[][] {{Integer.MAX_VALUE, 0}}, new byte[][] {pool}),
                new LayerSlice(2, z, new int[][] {{-2, 0}}, new byte[][] {pool}),
                new LayerSlice(2, z, new int[][] {{Integer.MIN_VALUE, 0}}, new byte[][] {pool}),
                new LayerSlice(2, z, new int[][] {{-1, 0}}, new byte[][] {cut}),
                new LayerSlice(2, z, new int[][] {{-1, 0}}, new byte[][] {new byte[0]})));
        // More codes than courses, no such cause, no such margin, twice.
        int[][] changes = {{0, 2}, {0, 255}, {2, 12}, {3, 0xff}, {5, 0x20}};
        for (int[] change : changes) {
            byte[] changed = pool.clone();
            changed[change[0]] = (byte) change[1];
            hostile.add(new LayerSlice(2, z, new int[][] {{-1, 0}}, new byte[][] {changed}));
        }
        for (LayerSlice one : hostile) {
            assertThatThrownBy(() -> one.check(2, 1, 2)).isInstanceOf(IllegalArgumentException.class);
        }
        byte[] three = new byte[CourseCodes.most(3)];
        CourseCodes.put(three, 0, new int[] {code, code - 2, code - 1});
        LayerSlice wrong = new LayerSlice(1, new double[] {4.0}, new int[][] {{-1}}, new byte[][] {three});
        wrong.check(1, 1, 3);
        three[three.length - 1] = 0x3f;
        assertThatThrownBy(() -> wrong.check(1, 1, 3))
                .as("beyond the list")
                .isInstanceOf(IllegalArgumentException.class);
    }

    /** A length that lies is compared with what is left of the file before memory is taken. */
    @Test
    void lengthsThatLieAreRefused() throws IOException {
        survey(site, GRID, 0.5, store(), 2);
        for (Path file : files()) {
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
                // After magic, version and the key is the number of columns, then that of rows.
                long at = 4 + 4 + 4 + file.getFileName().toString().length() + 4;
                channel.write(java.nio.ByteBuffer.wrap(new byte[] {-1, -1, -1, 0x7f}), at);
            }
        }
        assertThat(text(survey(site, GRID, 0.5, store(), 2))).isEqualTo(expected);
    }

    /** In a directory that may only be read, what is there is found, and nothing is written. */
    @Test
    void aReadOnlyDirectoryWorks() throws IOException {
        survey(site, GRID, 0.5, store(), 2);
        int count = files().size();
        Files.setPosixFilePermissions(place, PosixFilePermissions.fromString("r-xr-xr-x"));
        try {
            // Nothing is forbidden to the superuser, who finds the files, too.
            assertThat(text(survey(site, GRID, 0.5, store(), 2))).isEqualTo(expected);
            Assumptions.assumeFalse(Files.isWritable(place), "the superuser may write into any directory");
            assertThat(text(survey(site, GRID, 0.9, store(), 2)))
                    .isEqualTo(text(survey(site, GRID, 0.9, LayerStore.NONE, 2)));
            assertThat(notes).hasSizeLessThanOrEqualTo(1);
            assertThat(files()).hasSize(count);
        } finally {
            Files.setPosixFilePermissions(place, PosixFilePermissions.fromString("rwxr-xr-x"));
        }
    }

    /** Where no directory can be made, not even by the superuser, everything is assessed anew. */
    @ParameterizedTest
    @ValueSource(strings = {"file", "file/below", "file/far/below"})
    void aPlaceThatIsNoDirectoryWorks(String name) throws IOException {
        Path file = Files.writeString(place.resolve("file"), "not a directory");
        SiteStore kept = new SiteStore(Optional.of(place.resolve(name)), 1 << 28, 0.0, notes::add);
        for (int time = 0; time < 2; time++) {
            assertThat(text(survey(site, GRID, 0.5, LayerStore.of(site.settings(), Map.of(), kept), 2)))
                    .isEqualTo(expected);
        }
        assertThat(notes).singleElement().asString().contains(file.toString());
        assertThat(file).hasContent("not a directory");
        assertThat(files()).containsExactly(file);
    }

    /** Their code is not part of the key. */
    @Test
    void kindsOfOtherJarsAreNotKept() {
        assertThat(OwnCode.isAll(site.settings().world())).isTrue();
        site.settings().enabledSensors().values().forEach(sensor -> assertThat(OwnCode.isAll(sensor))
                .isTrue());
        assertThat(OwnCode.isAll(List.of(1.0, "text", Optional.of(2)))).isTrue();

        assertThat(OwnCode.isAll(Map.of("a", List.of(notes, new LayerStoreTest()))))
                .as("of the tests")
                .isFalse();
    }
}
