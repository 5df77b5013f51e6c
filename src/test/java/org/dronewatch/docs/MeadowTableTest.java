package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each number of the table about grass, night and rain is that of the run whose settings its row states. */
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
                Files.readString(PAGE).split("## Grass, night and rain\n", 2)[1].split("\n## ", 2)[0];
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

    @ParameterizedTest
    @MethodSource("rows")
    void aRowIsThatOfItsRun(Row row) {
        SceneRunner runner = new SceneRunner(new SceneFile(SCENE));
        row.settings().forEach(setting -> runner.set(setting[0], setting[1]));
        List<Observation> all = new ArrayList<>();
        SceneResult result =
                runner.onFrame(frame -> all.addAll(frame.observations())).run();
        assertThat(row.figures())
                .containsExactly(
                        first(result, "camera"),
                        number("%.2f", at(all, "camera", 600).figures().get(Observation.PROBABILITY)),
                        first(result, "radar"),
                        number("%.2f", at(all, "radar", 1000).figures().get(Observation.PROBABILITY)),
                        first(result, "radio"),
                        number("%.1f dB", at(all, "radio", 1000).value()));
    }

    private static String first(SceneResult result, String sensor) {
        return result.firstDetectionRange(0, sensor, "intruder").stream()
                .mapToObj(range -> number("%.0f m", range))
                .findFirst()
                .orElse(NEVER);
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
