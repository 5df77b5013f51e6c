package org.dronewatch.report.provenance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.dronewatch.report.file.ShellWord;
import org.dronewatch.setting.InputException;
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

    private static SceneDirectories from(Path scene, Path... inputs) {
        return new SceneDirectories(
                scene,
                ResultKind.PLACE,
                Pattern.compile("layout\\.yaml|report\\.html"),
                new CommandInputs(List.of(inputs)));
    }

    @Test
    void theNearestIsThatOfTheScene() {
        assertThat(from(site).nearest(any -> true)).contains(site);
        assertThat(from(site).nearest(any -> !any.equals(site))).contains(directory);
        assertThat(from(site).advice(any -> {})).isEqualTo("use --out " + ShellWord.of(site));
    }

    /** Output directories that are roots are refused. */
    @Test
    void theRootIsNone() {
        assertThat(from(site).nearest(any -> any.getParent() == null)).isEmpty();
        assertThat(from(site).advice(any -> {
                    throw new InputException("names a file elsewhere");
                }))
                .isEqualTo("put the scene and all files that it names into a separate directory, and use that for"
                        + " --out");
    }

    /** The modules of Java are in directories that nobody can write. */
    @Test
    void aDirectoryThatCannotBeWrittenIsNone() {
        Path modules = FileSystems.getFileSystem(URI.create("jrt:/")).getPath("/modules/java.base/java");

        assertThat(modules).isDirectory();
        assertThat(from(modules).nearest(any -> true)).isEmpty();
    }

    /** Beside results of the command, where its files could be replaced, but not its inputs. */
    @Test
    void anInputIsNotReplaced() throws IOException {
        Path scene = Files.writeString(site.resolve("layout.yaml"), "");
        Files.writeString(site.resolve("place.json"), "{}");

        assertThat(from(site).nearest(any -> true)).contains(site);
        assertThat(from(site, scene).nearest(any -> true)).contains(directory);
        assertThat(from(site, site.resolve("other.yaml")).nearest(any -> true)).contains(site);
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
