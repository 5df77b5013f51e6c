package org.dronewatch.report.file;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/**
 * A directory for unfinished files, used by one run at a time. A file in it is locked as long as the run goes on; the
 * lock ends with the process, however that ends, and the next process removes stale files.
 */
final class StagingLock implements AutoCloseable {
    private static final String LOCK = "lock";
    private static final int TRIES = 100;

    /**
     * Directories locked by this process, which must not even open a lock file that it has locked: closing it again
     * would free the lock.
     */
    private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

    private final Path directory;
    private final RandomAccessFile file;

    private StagingLock(Path directory, RandomAccessFile file) {
        this.directory = directory;
        this.file = file;
    }

    /**
     * Makes the directory, or takes over one that was left behind, empty but for the lock.
     *
     * @param directory absolute path of the directory, always under the same name
     * @return empty when another run has it
     */
    static Optional<StagingLock> acquire(Path directory) throws IOException {
        if (!HELD.add(directory)) {
            return Optional.empty();
        }
        Optional<StagingLock> lock = Optional.empty();
        try {
            lock = lock(directory);
            if (lock.isPresent()) {
                lock.get().clear();
            }
            return lock;
        } catch (IOException | RuntimeException e) {
            lock.ifPresent(StagingLock::close);
            throw e;
        } finally {
            if (lock.isEmpty()) {
                HELD.remove(directory);
            }
        }
    }

    private static Optional<StagingLock> lock(Path directory) throws IOException {
        Path name = directory.resolve(LOCK);
        IOException refused = null;
        for (int i = 0; i < TRIES; i++) {
            Files.createDirectories(directory);
            RandomAccessFile file;
            try {
                file = new RandomAccessFile(name.toFile(), "rw");
            } catch (IOException e) {
                // A run that is ending may just have removed the directory.
                refused = e;
                continue;
            }
            boolean held = false;
            try {
                FileLock lock;
                try {
                    lock = file.getChannel().tryLock();
                } catch (IOException e) {
                    // A file system without locks: runs of other processes cannot be distinguished there.
                    held = true;
                    return Optional.of(new StagingLock(directory, file));
                }
                // The locked file may meanwhile have been removed by the run that had locked it.
                held = lock != null && Files.exists(name);
                if (lock == null || held) {
                    return held ? Optional.of(new StagingLock(directory, file)) : Optional.empty();
                }
            } finally {
                if (!held) {
                    file.close();
                }
            }
        }
        if (refused != null) {
            throw refused;
        }
        return Optional.empty();
    }

    private void clear() throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                if (!file.equals(directory) && !file.equals(directory.resolve(LOCK))) {
                    Files.deleteIfExists(file);
                }
            }
        }
    }

    /** Removes the directory and its contents, and releases the lock. */
    @Override
    public void close() {
        Path name = directory.resolve(LOCK);
        boolean removed = false;
        try {
            clear();
            // The lock file is removed before the lock is released, so that no other run holds it yet; not every system
            // removes open files.
            removed = remove(name);
        } catch (IOException e) {
            // The results are where they belong; the next run removes what is left here.
            removed = false;
        } finally {
            unlock();
            if (!removed) {
                remove(name);
            }
            // If the directory is not empty, the next run already uses it.
            remove(directory);
            HELD.remove(directory);
        }
    }

    private void unlock() {
        try {
            file.close();
        } catch (IOException e) {
            // Nothing was written to it, and the lock ends with the process.
            return;
        }
    }

    private static boolean remove(Path file) {
        try {
            return Files.deleteIfExists(file);
        } catch (IOException e) {
            return false;
        }
    }
}
