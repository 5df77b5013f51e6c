package org.dronewatch.render.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.GradientPaint;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.dronewatch.render.Films;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FilmTest {
    /** What the encoder may lose, in steps of 255. */
    private static final double LOSS = 4.0;

    @TempDir
    private Path directory;

    /** A red square on its way across a picture of an odd size, from black to white. */
    private static BufferedImage picture(double time) {
        BufferedImage image = new BufferedImage(301, 199, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setPaint(new GradientPaint(0, 0, Color.BLACK, 300, 0, Color.WHITE));
        g.fillRect(0, 0, 301, 199);
        g.setColor(new Color(200, 40, 30));
        g.fillRect((int) (40 * time), 60, 50, 50);
        g.dispose();
        return image;
    }

    private Path written(String name, Film film) throws Exception {
        Path file = Files.createFile(directory.resolve(name));
        new FilmMaker(film, FilmTest::picture).write(file, FilmFormat.MP4, done -> {}, () -> false);
        return file;
    }

    @Test
    void aFilmPlaysBackFrameByFrame() throws Exception {
        Film film = new Film(1.0, 5.0, 10, 1.0);
        List<BufferedImage> frames = Films.frames(written("square.mp4", film));

        assertThat(frames).hasSize(41).hasSize(film.frames());
        for (int i = 0; i < frames.size(); i++) {
            BufferedImage frame = frames.get(i);
            assertThat(frame.getWidth()).isEqualTo(302);
            assertThat(frame.getHeight()).isEqualTo(200);
            assertThat(Films.difference(picture(film.time(i)), frame))
                    .as("frame %d", i)
                    .isLessThan(LOSS);
        }
        assertThat(new Color(frames.get(0).getRGB(299, 20)).getGreen())
                .as("white stays white")
                .isGreaterThan(244);
        assertThat(new Color(frames.get(0).getRGB(1, 20)).getGreen())
                .as("black stays black")
                .isLessThan(11);
    }

    @Test
    void theSamePicturesGiveTheSameBytesWheneverTheyAreWritten() throws Exception {
        Film film = new Film(0.0, 1.0, 10, 1.0);
        byte[] first = Files.readAllBytes(written("one.mp4", film));
        // Dates in MP4 files are in seconds.
        Thread.sleep(1100);
        assertThat(Files.readAllBytes(written("two.mp4", film))).isEqualTo(first);
    }

    @Test
    void aFilmShowsItsTimesAtItsSpeed() {
        Film film = new Film(2.0, 12.0, 25, 4.0);
        assertThat(film.frames()).isEqualTo(63);
        assertThat(film.time(0)).isEqualTo(2.0);
        assertThat(film.time(1)).isCloseTo(2.16, within(1e-12));
        assertThat(film.time(62)).isCloseTo(11.92, within(1e-12));
        assertThat(new Film(0.0, 0.3, 10, 1.0).frames())
                .as("rounding loses no frame")
                .isEqualTo(4);
        assertThat(new Film(3.0, 3.0, 25, 1.0).frames()).isEqualTo(1);
    }

    @Test
    void limitsAreNamed() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Film(2, 1, 25, 1))
                .withMessageContaining("2.0 s to 1.0 s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Film(0, 1, 0, 1))
                .withMessageContaining("fps 0: must be 1 to 60");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Film(0, 1, 61, 1))
                .withMessageContaining("fps 61");
        for (double speed : new double[] {0.0, -1.0, Double.NaN, 1001.0}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new Film(0, 1, 25, speed))
                    .withMessageContaining("must be 0.01 to 1000");
        }
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Film(0, 1e6, 25, 1))
                .withMessageContaining("25000001 frames: there must be at most 36000");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Film.checkSize(4097, 100))
                .withMessageContaining("4097 x 100 pixels: each side must be at most 4096");
    }

    @Test
    void aFilmThatIsGivenUpSaysSoAndAsksForNoMorePictures() throws Exception {
        Path file = Files.createFile(directory.resolve("half.mp4"));
        List<Double> asked = new ArrayList<>();
        FilmMaker maker = new FilmMaker(new Film(0.0, 5.0, 10, 1.0), time -> {
            asked.add(time);
            return picture(time);
        });
        int[] done = {0};

        assertThatExceptionOfType(CancellationException.class)
                .isThrownBy(() -> maker.write(file, FilmFormat.MP4, count -> done[0] = count, () -> done[0] == 3));
        assertThat(asked).hasSize(3);
    }

    @Test
    void aFilmOfAThreadThatIsInterruptedIsGivenUp() throws Exception {
        Path file = Files.createFile(directory.resolve("half.mp4"));
        FilmMaker maker = new FilmMaker(new Film(0.0, 5.0, 10, 1.0), FilmTest::picture);

        assertThatExceptionOfType(CancellationException.class)
                .isThrownBy(() -> maker.write(
                        file, FilmFormat.MP4, count -> Thread.currentThread().interrupt(), () -> false));
        assertThat(Thread.interrupted()).isTrue();
    }
}
