package org.dronewatch.render.film;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import org.dronewatch.render.GifFrames;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Films as GIF: read back by the platform's own reader and painted over one another, as browsers do. */
class GifEncoderTest {
    private static final int WIDTH = 301;
    private static final int HEIGHT = 199;

    @TempDir
    private Path directory;

    /** A red square on its way across a background of 200 greens. */
    private static BufferedImage picture(double time) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        for (int row = 0; row < HEIGHT; row++) {
            g.setColor(new Color(20, row, 60));
            g.fillRect(0, row, WIDTH, 1);
        }
        g.setColor(new Color(200, 40, 30));
        g.fillRect((int) (40 * time), 60, 50, 50);
        g.dispose();
        return image;
    }

    private Path written(String name, Film film) throws IOException {
        Path file = Files.createFile(directory.resolve(name));
        new FilmMaker(film, GifEncoderTest::picture).write(file, FilmFormat.GIF, done -> {}, () -> false);
        return file;
    }

    /** How long each frame is shown, in hundredths of a second, and how many frames ask for a repetition. */
    private record Timing(List<Integer> delays, int loops) {
        static Timing of(Path file) throws IOException {
            ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
            try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
                reader.setInput(in);
                List<Integer> delays = new ArrayList<>();
                int loops = 0;
                for (int i = 0; i < reader.getNumImages(true); i++) {
                    IIOMetadataNode root =
                            (IIOMetadataNode) reader.getImageMetadata(i).getAsTree("javax_imageio_gif_image_1.0");
                    IIOMetadataNode control = (IIOMetadataNode)
                            root.getElementsByTagName("GraphicControlExtension").item(0);
                    assertThat(control.getAttribute("disposalMethod")).isEqualTo("doNotDispose");
                    delays.add(Integer.valueOf(control.getAttribute("delayTime")));
                    loops += root.getElementsByTagName("ApplicationExtension").getLength();
                }
                return new Timing(delays, loops);
            } finally {
                reader.dispose();
            }
        }
    }

    @Test
    void aFilmPlaysBackFrameByFrame() throws IOException {
        Film film = new Film(0.0, 6.0, 10, 1.0);
        Path file = written("square.gif", film);
        List<BufferedImage> frames = GifFrames.of(file);
        assertThat(frames).hasSize(61);
        for (int i = 0; i < frames.size(); i++) {
            BufferedImage shown = frames.get(i);
            BufferedImage drawn = picture(film.time(i));
            int worst = IntStream.range(0, WIDTH * HEIGHT)
                    .map(pixel -> distance(
                            shown.getRGB(pixel % WIDTH, pixel / WIDTH), drawn.getRGB(pixel % WIDTH, pixel / WIDTH)))
                    .max()
                    .orElseThrow();
            assertThat(worst).as("frame %d", i).isLessThan(8);
        }
        assertThat(Timing.of(file).loops()).as("repeats").isEqualTo(1);
    }

    private static int distance(int one, int other) {
        return IntStream.of(0, 8, 16)
                .map(shift -> Math.abs((one >> shift & 255) - (other >> shift & 255)))
                .max()
                .orElseThrow();
    }

    /** 60 frames a second are not a whole number of hundredths each. */
    @Test
    void itLastsAsLongAsTheFilm() throws IOException {
        List<Integer> delays =
                Timing.of(written("fast.gif", new Film(0.0, 1.0, 60, 1.0))).delays();
        assertThat(delays).hasSize(61);
        assertThat(delays.stream().mapToInt(Integer::intValue).sum()).isEqualTo(102);
    }

    @Test
    void whatDoesNotMoveCostsNextToNothing() throws IOException {
        Path one = written("one.gif", new Film(0.0, 0.0, 10, 1.0));
        Path still = Files.createFile(directory.resolve("still.gif"));
        new FilmMaker(new Film(0.0, 10.0, 10, 1.0), time -> picture(0.0))
                .write(still, FilmFormat.GIF, done -> {}, () -> false);
        assertThat(Files.size(still)).isLessThan(Files.size(one) + 100 * 1000);
        assertThat(GifFrames.of(still)).hasSize(101);
    }

    @Test
    void theSamePicturesGiveTheSameBytes() throws IOException {
        Film film = new Film(0.0, 1.0, 10, 1.0);
        assertThat(written("a.gif", film)).hasSameBinaryContentAs(written("b.gif", film));
    }
}
