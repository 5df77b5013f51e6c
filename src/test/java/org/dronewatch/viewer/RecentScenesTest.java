package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecentScenesTest {
    @TempDir
    private Path directory;

    @Test
    void theLastAreKeptNewestFirstEachOnce() {
        Path file = directory.resolve("deep").resolve("recent-scenes.txt");
        RecentScenes recent = new RecentScenes(file);
        assertThat(recent.list()).isEmpty();
        for (int i = 0; i < 15; i++) {
            recent.add(directory.resolve("scene " + i + ".yaml"));
        }
        recent.add(directory.resolve("x").resolve("..").resolve("scene 10.yaml"));

        RecentScenes again = new RecentScenes(file);
        assertThat(again.list()).hasSize(RecentScenes.MOST).doesNotHaveDuplicates();
        assertThat(again.list().get(0))
                .isEqualTo(directory.resolve("scene 10.yaml").toAbsolutePath());
        assertThat(again.list().get(1))
                .isEqualTo(directory.resolve("scene 14.yaml").toAbsolutePath());
        again.remove(directory.resolve("scene 14.yaml"));
        assertThat(recent.list()).hasSize(RecentScenes.MOST - 1);
    }

    @Test
    void aBrokenOrHugeFileIsAnEmptyList() throws Exception {
        Path file = directory.resolve("recent-scenes.txt");
        Files.write(file, new byte[] {(byte) 0xc3, (byte) 0x28, 0, 1});
        assertThat(new RecentScenes(file).list()).isEmpty();
        Files.writeString(file, "a\u0000b.yaml\n");
        assertThat(new RecentScenes(file).list()).isEmpty();
        Files.writeString(file, "scene.yaml\n".repeat(20_000));
        assertThat(new RecentScenes(file).list()).isEmpty();
        RecentScenes nowhere = new RecentScenes(file.resolve("below a file"));
        nowhere.add(directory.resolve("scene.yaml"));
        assertThat(nowhere.list()).isEmpty();
    }
}
