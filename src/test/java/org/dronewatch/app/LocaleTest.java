package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Child;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Every file has the same bytes, whatever the user's language, digits, calendar, time zone and character set are. */
@Execution(ExecutionMode.CONCURRENT)
class LocaleTest {
    /** Turkish letters, Arabic digits and decimal sign, Buddhist years, and another time zone and character set. */
    private static final List<String> ALL_AT_ONCE = List.of(
            "-Duser.language=tr",
            "-Duser.country=TR",
            "-Duser.extensions=u-ca-buddhist-nu-arab",
            "-Duser.timezone=Asia/Kathmandu",
            "-Dfile.encoding=ISO-8859-1");

    /** Places that exist: in the long form. */
    private static final List<List<String>> ONE_BY_ONE = List.of(
            List.of("-Duser.language=tr", "-Duser.country=TR"),
            List.of("-Duser.language=ar", "-Duser.country=EG", "-Duser.extensions=u-nu-arab"));

    @TempDir
    private Path directory;

    @BeforeEach
    void scene() throws IOException {
        Files.copy(Program.FUZZ.resolve("square.obj"), directory.resolve("square.obj"));
        Files.writeString(
                directory.resolve("site.yaml"),
                """
                world: {models: [square.obj], origin: {latitude: 50.08 deg, longitude: 14.42 deg}}
                drones:
                  intruder:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [0, 1250, 30], to: [0, 1210, 10]}
                sensors:
                  eye: {kind: camera, position: [0, 1200, 6], width: 320, height: 240, aim: {lookAt: [0, 1250, 20]}}
                  ear: {kind: acoustic, position: [0, 1200, 8], propagation: {kind: energy-model, rays: 100}}
                run: {duration: 0.5 s}
                sweep: {parameter: sensors.eye.width, values: [320, 640]}
                """,
                StandardCharsets.UTF_8);
    }

    private Map<String, String> filesOf(Path folder) throws IOException {
        Map<String, String> files = new TreeMap<>();
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path file : all.filter(Files::isRegularFile).toList()) {
                String name = folder.relativize(file).toString();
                String text = Files.readString(file, StandardCharsets.ISO_8859_1);
                files.put(name, withoutClock(name, text));
            }
        }
        return files;
    }

    /** Without times, dates, and what the process was started with. */
    private static String withoutClock(String name, String text) {
        if (name.equals("provenance.json")) {
            return "";
        }
        return text.replaceAll("\"(load_s|build_s|wall_s|[a-z]+_s|real_time_factor)\" : [-+.0-9eE]+", "")
                .replaceAll("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:.]+Z", "")
                .replaceAll("[0-9.,]+ (times|s|ms)\\b[^<]*", "");
    }

    private Map<String, String> run(String name, List<String> place) throws IOException, InterruptedException {
        List<String> options = new ArrayList<>(place);
        options.add("-XX:+UseSerialGC");
        try (Child child = Program.start(
                directory, options, "run", "site.yaml", "--observations", "--threads", "1", "--out", name)) {
            Program.Outcome outcome = child.await();
            assertThat(outcome.code()).as(outcome.err()).isZero();
            Map<String, String> files = filesOf(directory.resolve(name));
            files.put("standard output", outcome.out());
            return files;
        }
    }

    @Thorough
    @Test
    void noFileDependsOnThePlace() throws IOException, InterruptedException {
        List<String> english = List.of("-Duser.language=en", "-Duser.country=US", "-Duser.timezone=UTC");
        Map<String, String> expected = run("results-0", english);
        assertThat(expected)
                .containsKeys("detections.csv", "observations.csv", "map.kml", "map.geojson", "report.html");
        assertThat(expected.keySet()).anyMatch(name -> name.startsWith("plots/"));
        List<List<String>> places = new ArrayList<>(List.of(ALL_AT_ONCE));
        places.addAll(LongForm.IS_ON ? ONE_BY_ONE : List.of());
        int number = 0;
        for (List<String> options : places) {
            Map<String, String> files = run("results-" + ++number, options);
            assertThat(files.keySet()).isEqualTo(expected.keySet());
            files.forEach((name, text) -> assertThat(text.replaceAll("results-[0-9]", ""))
                    .as(name + " with " + options)
                    .isEqualTo(expected.get(name).replaceAll("results-[0-9]", "")));
        }
    }
}
