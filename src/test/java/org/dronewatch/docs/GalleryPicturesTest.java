package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Map;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.viewer.gallery.ScenePictures;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The pictures of the viewer's gallery show the packaged scenes as the program draws them today. When it draws
 * otherwise, write them again: {@code mvn test -Dtest=GalleryPicturesTest -Ddronewatch.docs=write}.
 */
class GalleryPicturesTest {
    private static final Path PICTURES = Path.of("src", "main", "resources", "org", "dronewatch", "viewer", "gallery");

    /** The moment at which each scene shows best what it is about. */
    private static final Map<String, String> VIEWS = Map.of(
            "closed-space", "--time 0 --rays --max-order 1 --heard-only",
            "camera-range", "--time 30",
            "acoustic-range", "--time 45",
            "multi-sensor", "--time 12");

    @TempDir
    private Path directory;

    static List<String> names() {
        return PackagedScene.all().stream().map(PackagedScene::name).toList();
    }

    @ParameterizedTest
    @MethodSource("names")
    void aPictureIsAsTheProgramDrawsIt(String name) throws Exception {
        Path today = directory.resolve(name + ".png");
        DocPictures.run(
                "render %s --view orbit %s --size %dx%d --scale 0.8 --out OUT"
                        .formatted(name, VIEWS.get(name), ScenePictures.WIDTH, ScenePictures.HEIGHT),
                today);
        Path kept = PICTURES.resolve(today.getFileName());
        if ("write".equals(System.getProperty("dronewatch.docs"))) {
            Files.createDirectories(PICTURES);
            Files.copy(today, kept, StandardCopyOption.REPLACE_EXISTING);
        }
        BufferedImage drawn = DocPictures.read(today);
        assertThat(drawn.getWidth()).isEqualTo(ScenePictures.WIDTH);
        assertThat(drawn.getHeight()).isEqualTo(ScenePictures.HEIGHT);
        assertThat(Likeness.here().difference(DocPictures.read(kept), drawn))
                .as("%s; write it again with -Ddronewatch.docs=write", kept)
                .isEmpty();
    }
}
