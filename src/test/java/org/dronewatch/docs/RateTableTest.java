package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The ranges of cameras without an observer, at several frame rates, are those of the runs that the page names. */
class RateTableTest {
    private static final Path PAGE = Path.of("src/site/markdown/alert.md");
    private static final Path SCENE = Path.of("scenes/meadow.yaml");
    private static final List<Integer> RATES = List.of(2, 5, 25, 50);
    private static final int OBSERVED = 25;

    private static Stream<List<String>> rows() throws IOException {
        return Files.readString(PAGE)
                .split("\\| `sensors.camera` ", 2)[1]
                .split("\n\n", 2)[0]
                .lines()
                .skip(2)
                .map(line -> Arrays.stream(line.substring(1).split("\\|"))
                        .map(String::strip)
                        .toList());
    }

    private static List<Observation> run(String camera, String position, int rate) {
        SceneRunner runner = new SceneRunner(new SceneFile(SCENE));
        if (camera.startsWith("`")) {
            runner.set("sensors.camera", camera.replace("`", ""));
        }
        runner.set("sensors.camera.detection.byChance", "false");
        runner.set("sensors.camera.position", position.replace("`", ""));
        runner.set("sensors.camera.rate", Integer.toString(rate));
        runner.set("sensors.radar.enabled", "false");
        runner.set("sensors.radio.enabled", "false");
        List<Observation> all = new ArrayList<>();
        runner.onFrame(frame -> all.addAll(frame.observations())).run();
        return all;
    }

    @Test
    void thereAreFourRows() throws IOException {
        assertThat(rows()).hasSize(4);
    }

    @ParameterizedTest
    @MethodSource("rows")
    void eachFigureIsThatOfItsRun(List<String> row) {
        List<String> figures = new ArrayList<>();
        String observed = "";
        for (int rate : RATES) {
            List<Observation> looks = run(row.get(0), row.get(1), rate);
            figures.add(metres(looks.stream()
                    .filter(Observation::isDetected)
                    .mapToDouble(Observation::range)
                    .findFirst()));
            if (rate == OBSERVED) {
                observed = metres(FirstDetections.quantile(looks, FirstDetections.observers(looks), 0.5));
            }
        }
        figures.add(observed);
        assertThat(figures).isEqualTo(row.subList(2, row.size()));
    }

    private static String metres(OptionalDouble range) {
        return String.format(Locale.ROOT, "%.0f m", range.orElse(Double.NaN));
    }
}
