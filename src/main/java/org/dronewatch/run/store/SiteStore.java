package org.dronewatch.run.store;

import java.io.IOException;
import java.io.StreamCorruptedException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronewatch.setting.PlainText;

/**
 * Keeps, in the files of one directory, what took a long time to prepare. Each file is named by the hash of everything
 * that its contents depend on. Files that cannot be read, or are damaged, are ignored; a failure to write one is
 * reported only once. Several processes may use the same directory: a file is written under another name, and then
 * renamed.
 */
public final class SiteStore {
    /** The end of the names of its files. */
    static final String SUFFIX = ".site";

    /** The largest number of bytes of all files together; beyond it, the least recently used files are deleted. */
    static final long MOST_BYTES = 2L << 30;

    /** The minimum time that the preparation of a value must have taken for it to be kept, s. */
    static final double WORTH = 0.3;

    /** The directories reported by any store of this process: models, fields and others are kept in the same one. */
    private static final Set<Path> REPORTED = ConcurrentHashMap.newKeySet();

    private static final Pattern NAMES = Pattern.compile("[a-z]+-[0-9a-f]{64}\\.site");
    private static final Pattern UNFINISHED = Pattern.compile("[a-z]+-[0-9a-f]{64}\\.site.*\\.part");

    /** An unfinished file of this age was left behind by a process that has ended. */
    private static final Duration ABANDONED = Duration.ofHours(1);

    private final Optional<Path> directory;
    private final long mostBytes;
    private final double worth;
    private final Consumer<String> notes;

    /** The directories that could not be written, and for which a note has said so. */
    private final Set<Path> reported;

    private boolean failed;

    /**
     * A store.
     *
     * @param directory directory of the store, created when it is first needed; empty to keep nothing
     * @param mostBytes maximum total size of all files, bytes
     * @param worth minimum time that the preparation of a value must have taken for it to be kept, s
     * @param notes receives at most one line, when a file cannot be written
     */
    public SiteStore(Optional<Path> directory, long mostBytes, double worth, Consumer<String> notes) {
        this(directory, mostBytes, worth, notes, ConcurrentHashMap.newKeySet());
    }

    private SiteStore(
            Optional<Path> directory, long mostBytes, double worth, Consumer<String> notes, Set<Path> reported) {
        this.directory = directory;
        this.mostBytes = mostBytes;
        this.worth = worth;
        this.notes = notes;
        this.reported = reported;
    }

    /** A store of standard size for sites. */
    static SiteStore standard(StorePlace place, Consumer<String> notes) {
        return standard(place, WORTH, notes);
    }

    /**
     * A store of standard size.
     *
     * @param worth minimum time that the preparation of a value must have taken for it to be kept, s
     * @param notes receives a line when a file cannot be written, unless a store of this process has reported that
     *     before
     */
    public static SiteStore standard(StorePlace place, double worth, Consumer<String> notes) {
        return new SiteStore(place.directory(), MOST_BYTES, worth, notes, REPORTED);
    }

    /** Whether anything is kept. */
    public boolean isOn() {
        return directory.isPresent();
    }

    /** Whether anything can be found: if not, a caller need not hash what it reads. */
    boolean mayFind() {
        return directory.filter(Files::isDirectory).isPresent();
    }

    /** What was kept under a key; empty if nothing was kept, or the file is damaged. */
    public <T> Optional<T> find(StoreKey key, StoredForm<T> form) {
        if (!mayFind()) {
            return Optional.empty();
        }
        Path file = directory.orElseThrow().resolve(key.fileName());
        if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
            return Optional.empty();
        }
        try (FileChannel channel = FileChannel.open(file)) {
            if (channel.size() > mostBytes) {
                return Optional.empty();
            }
            StoreReader source = new StoreReader(channel, channel.size());
            checkHeader(source, key);
            T value = form.read(source);
            source.finish();
            markUsed(file);
            return Optional.of(value);
        } catch (IOException | IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private static void checkHeader(StoreReader source, StoreKey key) throws IOException {
        if (source.nextInt() != StoredForms.MAGIC
                || source.nextInt() != StoredForms.VERSION
                || !source.nextText().equals(key.fileName())) {
            throw new StreamCorruptedException("another file");
        }
    }

    /** Marks an entry as used, so that it is not the next to be deleted. */
    private static void markUsed(Path file) {
        try {
            Files.setLastModifiedTime(file, FileTime.from(Instant.now()));
        } catch (IOException e) {
            // In a directory that only others may write, they decide what is deleted.
            return;
        }
    }

    /**
     * Keeps a value, if it took long enough to prepare.
     *
     * @param key only computed if the value is kept
     * @param seconds time that the preparation took, s
     */
    public <T> void keep(Supplier<StoreKey> key, StoredForm<T> form, T value, double seconds) {
        if (directory.isEmpty() || seconds < worth || failed) {
            return;
        }
        try {
            Path there = Files.createDirectories(directory.get());
            write(there, key.get(), form, value);
            deleteOldest(there);
        } catch (ClosedByInterruptException e) {
            // The user wants the program to stop; whether it keeps something does not matter.
            failed = true;
        } catch (IOException | SecurityException e) {
            failed = true;
            if (reported.add(directory.get())) {
                notes.accept("prepared data are not kept for the next start: "
                        + PlainText.line(reason(e, directory.get())) + " (--no-cache avoids the attempt)");
            }
        }
    }

    /** The reason in words, without the name of a temporary file. */
    private static String reason(Exception problem, Path directory) {
        if (problem instanceof AccessDeniedException) {
            return directory + ": permission denied";
        }
        if (problem instanceof FileAlreadyExistsException known) {
            return known.getFile() + " is a file";
        }
        return problem.getMessage() == null ? problem.getClass().getSimpleName() : problem.getMessage();
    }

    private <T> void write(Path there, StoreKey key, StoredForm<T> form, T value) throws IOException {
        Path unfinished = Files.createTempFile(there, key.fileName(), ".part");
        try {
            try (FileChannel channel = FileChannel.open(unfinished, StandardOpenOption.WRITE)) {
                StoreWriter target = new StoreWriter(channel);
                target.addInt(StoredForms.MAGIC);
                target.addInt(StoredForms.VERSION);
                target.addText(key.fileName());
                form.write(value, target);
                target.finish();
            }
            if (Files.size(unfinished) <= mostBytes) {
                rename(unfinished, there.resolve(key.fileName()));
            }
        } finally {
            Files.deleteIfExists(unfinished);
        }
    }

    private static void rename(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Deletes the least recently used files until the others fit; nothing else in the directory is touched. */
    private void deleteOldest(Path there) throws IOException {
        List<Kept> kept = new ArrayList<>();
        try (Stream<Path> files = Files.list(there)) {
            for (Path file : files.toList()) {
                String name = String.valueOf(file.getFileName());
                if (NAMES.matcher(name).matches()) {
                    Kept.of(file).ifPresent(kept::add);
                } else if (UNFINISHED.matcher(name).matches()) {
                    Kept.of(file).filter(Kept::isAbandoned).ifPresent(Kept::delete);
                }
            }
        }
        kept.sort(Comparator.comparing(Kept::used));
        long total = kept.stream().mapToLong(Kept::bytes).sum();
        for (Kept oldest : kept) {
            if (total > mostBytes) {
                oldest.delete();
                total -= oldest.bytes();
            }
        }
    }

    private record Kept(Path file, long bytes, Instant used) {
        /** Empty if another process has just deleted it. */
        static Optional<Kept> of(Path file) {
            try {
                return Optional.of(new Kept(
                        file, Files.size(file), Files.getLastModifiedTime(file).toInstant()));
            } catch (IOException e) {
                return Optional.empty();
            }
        }

        boolean isAbandoned() {
            return used.isBefore(Instant.now().minus(ABANDONED));
        }

        void delete() {
            try {
                Files.deleteIfExists(file);
            } catch (IOException e) {
                // Another process reads it, on a system that then forbids that: it is deleted the next time.
                return;
            }
        }
    }
}
