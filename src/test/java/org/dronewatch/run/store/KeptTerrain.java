package org.dronewatch.run.store;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.world.WorldSettings;

/** A terrain in a store, which shows whether it is found there. */
public final class KeptTerrain {
    private static final FileTime LONG_AGO = FileTime.from(Instant.parse("2001-01-01T00:00:00Z"));

    private final Path store;

    /**
     * Keeps the terrain of a world.
     *
     * @param directory of the files of the world
     * @param store a new directory
     */
    public KeptTerrain(WorldSettings world, Path directory, Path store) {
        this.store = store;
        SiteStore all = new SiteStore(Optional.of(store), 1 << 30, 0.0, note -> {});
        new PreparedSites(directory, all, new TreeMemory(), 1, note -> {})
                .terrain(world.terrain().orElseThrow(), world.origin().orElseThrow());
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(store)) {
            return files.sorted().toList();
        }
    }

    /** Whether something uses the store, or adds to it. */
    public boolean isUsedBy(Runnable something) {
        try {
            List<Path> before = files();
            for (Path file : before) {
                Files.setLastModifiedTime(file, LONG_AGO);
            }
            something.run();
            List<Path> after = files();
            return !after.equals(before)
                    || !Files.getLastModifiedTime(after.get(0)).equals(LONG_AGO);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
