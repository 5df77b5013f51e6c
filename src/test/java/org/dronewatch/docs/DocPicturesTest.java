package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.dronewatch.docs.DocPictures.DocPicture;
import org.dronewatch.docs.SitePages.Link;
import org.dronewatch.docs.SitePages.Text;
import org.dronewatch.render.GifFrames;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The pictures in the pages show what the program draws today. When the program draws otherwise, write them again:
 * {@code mvn test -Dtest=DocPicturesTest -Ddronewatch.docs=write}. Plots of speeds are measured again with
 * {@code -Dcosts} beside it. Those that take long are compared only with {@code -Ddronewatch.docs=all}, which the CI
 * does.
 */
class DocPicturesTest {
    @TempDir
    private Path directory;

    static List<DocPicture> drawn() {
        return DocPictures.DRAWN;
    }

    @ParameterizedTest
    @MethodSource("drawn")
    void aPictureIsAsTheProgramDrawsIt(DocPicture picture) throws Exception {
        assumeTrue(!picture.isSlow() || System.getProperty("dronewatch.docs") != null, "slow: -Ddronewatch.docs=all");
        BufferedImage today = picture.drawing().draw(directory);
        Path kept = Files.createDirectories(Path.of("target", "doc-pictures")).resolve(picture.name() + ".png");
        ImageIO.write(today, "png", kept.toFile());
        if ("write".equals(System.getProperty("dronewatch.docs"))) {
            Files.copy(kept, picture.file(), StandardCopyOption.REPLACE_EXISTING);
        }
        assertThat(Likeness.here().difference(DocPictures.read(picture.file()), today))
                .as("%s against %s; write it again with -Ddronewatch.docs=write", picture.file(), kept)
                .isEmpty();
    }

    /** Three of its frames: each has all changes before it painted over the first. */
    @Test
    @EnabledIfSystemProperty(named = "dronewatch.docs", matches = "all|write")
    void theFilmIsAsTheProgramMakesIt() throws IOException {
        Path today = DocPictures.film(directory);
        Path kept = DocPictures.DIRECTORY.resolve(DocPictures.FILM);
        if ("write".equals(System.getProperty("dronewatch.docs"))) {
            Files.copy(today, kept, StandardCopyOption.REPLACE_EXISTING);
        }
        List<BufferedImage> shown = GifFrames.of(kept);
        List<BufferedImage> made = GifFrames.of(today);
        assertThat(shown).hasSameSizeAs(made).hasSizeGreaterThan(50);
        for (int frame : new int[] {0, made.size() / 2, made.size() - 1}) {
            assertThat(Likeness.here().difference(shown.get(frame), made.get(frame)))
                    .as("frame %d", frame)
                    .isEmpty();
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "costs", matches = ".*")
    void speedsAreMeasured() throws IOException {
        DocPictures.measure(directory);
    }

    @Test
    void everyPictureIsMadeByTheProgram() throws IOException {
        TreeSet<String> made = Stream.concat(
                        DocPictures.DRAWN.stream().map(DocPicture::name), DocPictures.MEASURED.stream())
                .map(name -> name + ".png")
                .collect(Collectors.toCollection(TreeSet::new));
        // Drawings (.svg) are the concern of GeneratedDocsTest.
        assertThat(files().stream().filter(name -> name.endsWith(".png"))).containsExactlyInAnyOrderElementsOf(made);
    }

    @Test
    void everyPictureIsInAPage() throws IOException {
        TreeSet<String> shown = new TreeSet<>();
        for (Path page : SitePages.sources(Path.of("").toAbsolutePath())) {
            for (Link link : new Text(Files.readString(page)).links()) {
                shown.add(link.to().replaceFirst(".*/", ""));
            }
        }
        assertThat(shown).containsAll(files());
    }

    private static TreeSet<String> files() throws IOException {
        try (Stream<Path> files = Files.list(DocPictures.DIRECTORY)) {
            return files.map(file -> file.getFileName().toString()).collect(Collectors.toCollection(TreeSet::new));
        }
    }
}
