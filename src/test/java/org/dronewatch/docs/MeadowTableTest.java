package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.camera.CameraSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each number of the table about grass, night and rain is that of the run whose settings its row states, or follows
 * from the probabilities of that run.
 */
class MeadowTableTest {
    private static final Path PAGE = Path.of("src/site/markdown/means.md");
    private static final Path SCENE = Path.of("scenes/meadow.yaml");
    private static final Pattern SETTING = Pattern.compile("--set (\\S+?)=\"?([^\"]+?)\"?(?= --set|$)");
    private static final String NEVER = "never";

    /** A row: what it is about, the settings of its run, and what the run says. */
    record Row(String name, List<String[]> settings, List<String> figures) {
        static Row of(String line) {
            List<String> cells = Arrays.stream(
                            line.substring(1, line.lastIndexOf('|')).split("\\|"))
                    .map(String::strip)
                    .toList();
            List<String[]> settings = new ArrayList<>();
            Matcher matcher = SETTING.matcher(cells.get(1).replace("`", "").replace("<br>", " "));
            while (matcher.find()) {
                settings.add(new String[] {matcher.group(1), matcher.group(2)});
            }
            return new Row(cells.get(0), settings, cells.subList(2, cells.size()));
        }

        @Override
        public String toString() {
            return name;
        }
    }

    static List<Row> rows() throws IOException {
        String section =
                Files.readString(PAGE).split("## Grass, night and rain\n", 2)[1].split("\n##", 2)[0];
        return section.lines()
                .filter(line -> line.startsWith("|") && !line.startsWith("|-") && !line.startsWith("| |"))
                .map(Row::of)
                .toList();
    }

    @Test
    void theTableHasItsRows() throws IOException {
        assertThat(rows())
                .extracting(Row::name)
                .containsExactly(
                        "by day, dry",
                        "without the ground",
                        "street lighting",
                        "full moon",
                        "heavy rain",
                        "full moon and heavy rain");
        assertThat(rows().get(0).settings()).isEmpty();
        assertThat(rows().get(5).settings()).hasSize(2);
    }

    /** One run of each row. Its seed makes no difference: medians follow from probabilities, which draw nothing. */
    private static final Map<String, List<Observation>> RUNS = new HashMap<>();

    private static synchronized List<Observation> run(List<String[]> settings, long seed) {
        String key = seed + settings.stream().map(Arrays::toString).toList().toString();
        return RUNS.computeIfAbsent(key, unseen -> {
            SceneRunner runner = new SceneRunner(new SceneFile(SCENE)).seed(seed);
            settings.forEach(setting -> runner.set(setting[0], setting[1]));
            List<Observation> all = new ArrayList<>();
            runner.onFrame(frame -> all.addAll(frame.observations())).run();
            return all;
        });
    }

    @ParameterizedTest
    @MethodSource("rows")
    void aRowIsThatOfItsRun(Row row) {
        List<Observation> all = run(row.settings(), 1);
        assertThat(row.figures())
                .containsExactly(
                        inWords(of(all, "camera"), FirstDetections.observers(of(all, "camera"))),
                        number("%.2f", at(all, "camera", 600).figures().get(Observation.PROBABILITY)),
                        inWords(of(all, "radar"), FirstDetections.independentLooks(of(all, "radar"))),
                        number("%.2f", at(all, "radar", 1000).figures().get(Observation.PROBABILITY)),
                        first(all, "radio"),
                        number("%.1f dB", at(all, "radio", 1000).value()));
    }

    /** What the sentences below the table say. */
    @Test
    void theProseIsThatOfTheRuns() throws IOException {
        String prose = Files.readString(PAGE)
                .split("- \\*\\*The ground", 2)[1]
                .split("\n## ", 2)[0]
                .replaceAll("\\s+", " ");
        List<Observation> day = run(rows().get(0).settings(), 1);
        List<Observation> bare = run(rows().get(1).settings(), 1);
        double strongest = of(day, "radar").stream()
                .mapToDouble(one -> one.figures().get("ground_reflection_db"))
                .max()
                .orElseThrow();
        assertThat(prose).contains(number("up to %.0f dB stronger", strongest));
        assertThat(prose).contains(number("first detection is %.0f m longer", median(day) - median(bare)));
        double lost = chance(bare) - chance(day);
        List<String[]> withoutClutter = List.<String[]>of(new String[] {"sensors.radar.clutter.improvement", "150 dB"});
        double grass = chance(run(withoutClutter, 1)) - chance(day);
        assertThat(prose).contains(number("lower by %.2f, of which ", lost) + number("%.2f is due to", grass));
        double rain =
                at(run(rows().get(4).settings(), 1), "radar", 1000).figures().get("clutter_to_noise_db");
        assertThat(prose).contains(number("at 1 km they are %.1f dB above the noise", rain));
    }

    private static double median(List<Observation> all) {
        return FirstDetections.quantile(of(all, "radar"), FirstDetections.independentLooks(of(all, "radar")), 0.5)
                .orElseThrow();
    }

    private static double chance(List<Observation> all) {
        return at(all, "radar", 1000).figures().get(Observation.PROBABILITY);
    }

    /** The observer of the closed form is that of the scene: another way to decide has other first detections. */
    @Test
    void theSceneHasTheObserverOfTheClosedForm() {
        CameraSettings camera =
                (CameraSettings) new SceneFile(SCENE).describe().sensors().get("camera");
        assertThat(camera.detection().byChance()).isTrue();
    }

    @Test
    void firstDetectionsByTheRadarScatterAsTheQuantilesSay() {
        List<Observation> looks = of(run(List.of(), 1), "radar");
        scatter(looks, FirstDetections.independentLooks(looks), first("radar", "camera", 100, 20));
    }

    @Test
    void firstDetectionsByTheCameraScatterAsTheQuantilesSay() {
        List<Observation> looks = of(run(List.of(), 1), "camera");
        scatter(looks, FirstDetections.observers(looks), first("camera", "radar", 200, 20));
    }

    /** The ranges of the first detections by a sensor with some seeds, m; 0 for none. */
    private static double[] first(String sensor, String other, int seed, int runs) {
        List<String[]> alone = List.of(
                new String[] {"sensors." + other + ".enabled", "false"},
                new String[] {"sensors.radio.enabled", "false"});
        return IntStream.range(seed, seed + runs)
                .mapToDouble(i -> of(run(alone, i), sensor).stream()
                        .filter(Observation::isDetected)
                        .mapToDouble(Observation::range)
                        .findFirst()
                        .orElse(0.0))
                .toArray();
    }

    /** As many first detections lie beyond each quantile as binomial scatter allows, four standard deviations. */
    private static void scatter(List<Observation> looks, double[] detected, double[] first) {
        for (double share : new double[] {0.1, 0.5, 0.9}) {
            double range = FirstDetections.quantile(looks, detected, share).orElseThrow();
            int look = IntStream.range(0, detected.length)
                    .filter(i -> detected[i] >= share)
                    .findFirst()
                    .orElseThrow();
            double farther =
                    Arrays.stream(first).filter(one -> one >= range - 1e-6).count();
            assertThat(farther)
                    .as("of %d seeds, first detections beyond %.0f m: %s", first.length, range, Arrays.toString(first))
                    .isCloseTo(
                            first.length * detected[look],
                            within(4.0 * Math.sqrt(first.length * share * (1.0 - share))));
        }
    }

    private static List<Observation> of(List<Observation> all, String sensor) {
        return all.stream().filter(one -> one.look().sensor().equals(sensor)).toList();
    }

    /** The median, and the ranges by which nine tenths and one tenth of the runs have detected the drone. */
    private static String inWords(List<Observation> looks, double[] detected) {
        String median = metres(FirstDetections.quantile(looks, detected, 0.5));
        return median.equals(NEVER)
                ? NEVER
                : median + " ("
                        + metres(FirstDetections.quantile(looks, detected, 0.9)).replace(" m", "") + " to "
                        + metres(FirstDetections.quantile(looks, detected, 0.1)) + ")";
    }

    private static String metres(OptionalDouble range) {
        return range.isPresent() ? number("%.0f m", range.getAsDouble()) : NEVER;
    }

    private static String first(List<Observation> all, String sensor) {
        return metres(of(all, sensor).stream()
                .filter(Observation::isDetected)
                .mapToDouble(Observation::range)
                .findFirst());
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }

    /** What a sensor observes nearest to a range. */
    private static Observation at(List<Observation> all, String sensor, double range) {
        return all.stream()
                .filter(one -> one.look().sensor().equals(sensor))
                .min(Comparator.comparingDouble(one -> Math.abs(one.range() - range)))
                .orElseThrow();
    }
}
