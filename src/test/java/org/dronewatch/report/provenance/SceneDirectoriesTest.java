package org.dronewatch.report.provenance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Directories that a command advises are directories that it takes. */
class SceneDirectoriesTest {
    @TempDir
    private Path directory;

    private Path site;

    @BeforeEach
    void make() throws IOException {
        site = Files.createDirectories(directory.resolve("site"));
    }

    private static SceneDirectories from(Path scene) {
        return new SceneDirectories(scene, ResultKind.PLACE, Pattern.compile("layout\\.yaml|report\\.html"));
    }

    @Test
    void theNearestIsThatOfTheScene() {
        assertThat(from(site).nearest(any -> true)).contains(site);
        assertThat(from(site).nearest(any -> !any.equals(site))).contains(directory);
        assertThat(from(site).advice(any -> true)).isEqualTo("use --out " + site);
    }

    /** Output directories that are roots are refused. */
    @Test
    void theRootIsNone() {
        assertThat(from(site).nearest(any -> any.getParent() == null)).isEmpty();
        assertThat(from(site).advice(any -> any.getParent() == null))
                .isEqualTo("put the scene and all files that it names into a directory of their own, and use that for"
                        + " --out");
    }

    /** The modules of Java are in directories that nobody can write. */
    @Test
    void aDirectoryThatCannotBeWrittenIsNone() {
        Path modules = FileSystems.getFileSystem(URI.create("jrt:/")).getPath("/modules/java.base/java");

        assertThat(modules).isDirectory();
        assertThat(from(modules).nearest(any -> true)).isEmpty();
    }

    /** Files of the user have these names, unless an earlier command wrote them. */
    @Test
    void filesOfTheUserAreNotReplaced() throws IOException {
        Files.writeString(site.resolve("report.html"), "");
        assertThat(from(site).nearest(any -> true)).contains(directory);

        Files.writeString(site.resolve("place.json"), "{}");
        assertThat(from(site).nearest(any -> true)).contains(site);

        Files.writeString(site.resolve("route.json"), "{}");
        assertThat(from(site).nearest(any -> true)).contains(directory);
    }
}
