package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The report of the closed space shows what its camera saw, and the rays to its microphone if they are wanted. */
class ReportPicturesTest {
    private static final Pattern FIGURE =
            Pattern.compile("base64,([^\"]+)\".*?<figcaption>(.*?)</figcaption>", Pattern.DOTALL);

    @TempDir
    private static Path directory;

    private static Path rayFile;
    /** Of the scene as it is. */
    private static List<Shown> asItIs;
    /** Of a camera and a microphone that detect nothing. */
    private static List<Shown> undetected;

    @BeforeAll
    static void runs() throws IOException {
        rayFile = directory.resolve("rays.obj");
        asItIs = figures("--rays", rayFile.toString());
        undetected =
                figures("--set", "sensors.camera.detection.pixels=691", "--set", "sensors.microphone.threshold=90");
    }

    private record Shown(String caption, BufferedImage image) {}

    private static List<Shown> figures(String... options) throws IOException {
        Path out = directory.resolve("out");
        List<String> words =
                new ArrayList<>(List.of("run", "closed-space", "--set", "run.duration=0.1 s", "--out", out.toString()));
        words.addAll(List.of(options));
        Program.Outcome outcome = Program.run(words.toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        List<Shown> shown = new ArrayList<>();
        Matcher figures = FIGURE.matcher(Files.readString(out.resolve("report.html")));
        while (figures.find()) {
            byte[] png = Base64.getMimeDecoder().decode(figures.group(1));
            shown.add(new Shown(
                    figures.group(2).replace("&#39;", "'").replace("&apos;", "'"),
                    ImageIO.read(new ByteArrayInputStream(png))));
        }
        return shown;
    }

    private static List<Shown> about(List<Shown> figures, String words) {
        return figures.stream().filter(one -> one.caption().contains(words)).toList();
    }

    private static int orange(BufferedImage image) {
        int count = 0;
        for (int pixel : image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth())) {
            count += (pixel & 0xffffff) == 0xff6a00 ? 1 : 0;
        }
        return count;
    }

    @Test
    void aCameraShowsItsFirstDetection() {
        List<Shown> depth = about(asItIs, "Picture taken by 'camera'");
        assertThat(depth).singleElement().satisfies(figure -> {
            assertThat(figure.caption())
                    .contains("first detected 'quadrotor', 0.0 s after the start, at a range of 10.0 m")
                    .contains("(690 of 800 x 800 pixels)");
            assertThat(figure.image().getWidth()).isEqualTo(640);
            assertThat(figure.image().getHeight()).isEqualTo(640);
            // 690 pixels in a picture 0.8 times as wide and high, and up to one more at each of some 60 ends of rows.
            assertThat(orange(figure.image())).isBetween(442, 500);
        });
        assertThat(about(undetected, "Picture taken by 'camera'"))
                .as("never detected")
                .isEmpty();
    }

    @Test
    void raysAreDrawnIfTheMicrophoneShowsThem() throws IOException {
        List<Shown> rays = about(asItIs, "The sound rays from");
        long segments = Files.readAllLines(rayFile).stream()
                .filter(line -> line.startsWith("l "))
                .count();
        assertThat(segments).isGreaterThan(5_000);
        assertThat(rays).singleElement().satisfies(figure -> {
            assertThat(figure.caption())
                    .contains(
                            "from 'quadrotor' to 'microphone' when the drone was first detected, at a range of 10.0 m")
                    .contains(String.format("at a range of 10.0 m: %,d segments", segments));
            assertThat(figure.image().getWidth()).isEqualTo(1000);
        });
        assertThat(about(undetected, "The sound rays from")).singleElement().satisfies(figure -> assertThat(
                        figure.caption())
                .contains("at the start, since the drone was never detected"));
        List<Shown> hidden = figures(
                "--set",
                "sensors.microphone.drawRays=false",
                "--set",
                "sensors.camera.width=64",
                "--set",
                "sensors.camera.height=64");
        assertThat(about(hidden, "The sound rays from")).as("not to be drawn").isEmpty();
    }
}
