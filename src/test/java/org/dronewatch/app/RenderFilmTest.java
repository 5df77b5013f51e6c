package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.dronewatch.Thorough;
import org.dronewatch.render.Films;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Films of the site and of what a camera sees. */
@Thorough
class RenderFilmTest extends CuedCamera {
    @Test
    void aFilmOfTheSiteBeginsAndEndsAsItsPictures() throws Exception {
        Path film = directory.resolve("site.mp4");
        String[] view = {"--view", "orbit", "--size", "640x480", "--out", film.toString()};
        String said = render(
                Stream.concat(Stream.of("--from", "2", "--to", "12", "--fps", "2", "--speed", "2.5"), Stream.of(view))
                        .toArray(String[]::new));
        assertThat(said).isEqualTo(film + ": 9 frames, 2 per second, from 2.00 s to 12.00 s\n");

        List<BufferedImage> frames = Films.frames(film);
        assertThat(frames).hasSize(9);
        Path picture = directory.resolve("site.png");
        for (int frame : new int[] {0, 8}) {
            view[5] = picture.toString();
            render(Stream.concat(Stream.of("--time", frame == 0 ? "2" : "12"), Stream.of(view))
                    .toArray(String[]::new));
            BufferedImage drawn = ImageIO.read(picture.toFile());
            assertThat(frames.get(frame).getWidth()).isEqualTo(640);
            assertThat(Films.difference(drawn, frames.get(frame))).isLessThan(6.0);
            assertThat(Films.difference(drawn, frames.get(frame)))
                    .as("nearer to its own time than to the other")
                    .isLessThan(Films.difference(drawn, frames.get(8 - frame)));
        }
    }

    @Test
    void aFilmOfACameraShowsItsLooksAndIsTheSameForTheSameSeed() throws Exception {
        String[] options = {
            "--camera",
            "cued",
            "--from",
            "11",
            "--to",
            "12",
            "--fps",
            "4",
            "--set",
            "sensors.cued.width=320",
            "--set",
            "sensors.cued.height=200",
            "--out",
            directory.resolve("one.mp4").toString()
        };
        render(options);
        options[13] = directory.resolve("two.mp4").toString();
        render(options);
        assertThat(Files.readAllBytes(directory.resolve("two.mp4")))
                .isEqualTo(Files.readAllBytes(directory.resolve("one.mp4")));

        List<BufferedImage> frames = Films.frames(directory.resolve("one.mp4"));
        assertThat(frames).hasSize(5);
        Path picture = directory.resolve("cued.png");
        render(
                "--camera",
                "cued",
                "--time",
                "12",
                "--set",
                "sensors.cued.width=320",
                "--set",
                "sensors.cued.height=200",
                "--out",
                picture.toString());
        assertThat(Films.difference(ImageIO.read(picture.toFile()), frames.get(4)))
                .isLessThan(6.0);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--view top --time 3 --out DIR/a.mp4          | --time 3: a video takes --from and --to",
                "--view top --fps 10 --out DIR/a.png          | --fps 10: applies only to videos (--out FILE.mp4 or FILE.gif)",
                "--camera cued --from 1 --out DIR/a.pfm       | --from 1: applies only to videos",
                "--view top --to 15 --out DIR/a.mp4           | --to 15: must be 0 to 14.0 s",
                "--view top --from 5 --to 4 --out DIR/a.mp4   | --from 5: must not be after --to 4",
                "--view top --fps 0 --out DIR/a.mp4           | fps 0: must be 1 to 60",
                "--view top --speed 0 --out DIR/a.mp4         | speed 0.0: must be 0.01 to 1000",
                "--view top --speed 0.01 --fps 60 --out DIR/a.mp4 | 84001 frames: there must be at most 36000",
                "--view top --size 5000x100 --out DIR/a.mp4   | --size 5000x100: a video of 5000 x 100 pixels:"
                        + " each side must",
                "--view top --rays --out DIR/a.mp4            | --rays: rays are traced at a single time",
                "--view top --out png                         | must end in .png, .pfm, .mp4 or .gif",
                "--view top --out DIR/a.avi                   | must end in .png, .pfm, .mp4 or .gif",
                "--camera cued --out DIR/none/a.mp4           | no directory",
            })
    void aFilmThatCannotBeIsRefusedInALine(String options, String message) throws IOException {
        String[] words = ("render " + scene + " " + options.replace("DIR", directory.toString())).split("\\s+");
        Program.Outcome outcome = Program.run(words);

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.err().strip().lines()).hasSize(1).allSatisfy(line -> assertThat(line)
                .contains(message));
        try (Stream<Path> files = Files.list(directory)) {
            assertThat(files).containsExactly(scene);
        }
    }

    /** Whoever asks the command to end interrupts its thread: in the simulation, or while the film is written. */
    @Test
    void anInterruptedFilmLeavesNothingAndSaysSo() throws Exception {
        for (int wait : new int[] {200, 2500}) {
            StringWriter err = new StringWriter();
            int[] code = {-1};
            Thread command = new Thread(() -> code[0] = Main.execute(
                    new PrintWriter(new StringWriter()),
                    new PrintWriter(err, true),
                    "render",
                    scene.toString(),
                    "--camera",
                    "cued",
                    "--fps",
                    "60",
                    "--speed",
                    "0.05",
                    "--out",
                    directory.resolve("long.mp4").toString()));
            command.start();
            Thread.sleep(wait);
            command.interrupt();
            command.join(30_000);

            assertThat(command.isAlive()).isFalse();
            assertThat(code[0]).isEqualTo(1);
            assertThat(err.toString().strip().lines().reduce((first, last) -> last))
                    .contains("interrupted: nothing was written");
            try (Stream<Path> files = Files.list(directory)) {
                assertThat(files).containsExactly(scene);
            }
        }
    }
}
