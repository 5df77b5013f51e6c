package org.dronewatch.run.store;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import java.util.zip.CRC32C;
import java.util.zip.Checksum;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.dronewatch.setting.input.FileHash;

/**
 * Identifies the code that prepares sites: what another build, another Java or another kind of processor prepared is
 * not taken, since its results may differ in the last bit.
 */
final class CodeStamp {
    private static final String TEXT = FileHash.ofText(System.getProperty("java.vm.name")
            + System.getProperty("java.vm.version")
            + System.getProperty("os.arch")
            + code());

    /** A jar ends with this many bytes, which begin with a mark, if it has no comment. */
    private static final int END_BYTES = 22;

    private static final int END_MARK = 0x06054b50;

    /** Where in them the size of the list of entries is, and where its start in the file. */
    private static final int END_SIZE = 12;

    private static final int END_START = 16;

    private CodeStamp() {}

    static String text() {
        return TEXT;
    }

    /** Makes it in the background: listing thousands of classes takes as long as reading a model. */
    static void prepare() {
        CompletableFuture.runAsync(CodeStamp::text);
    }

    /** The entries of the program's jar with their checksums, or the files of a directory with their times. */
    private static String code() {
        try {
            CodeSource source = CodeStamp.class.getProtectionDomain().getCodeSource();
            Path path = Path.of(source.getLocation().toURI());
            return Files.isDirectory(path) ? files(path) : jar(path);
        } catch (IOException | URISyntaxException | RuntimeException e) {
            // Unknown code agrees with nothing, not even with itself.
            return UUID.randomUUID().toString();
        }
    }

    /** Two checksums of the jar's own list of its thousands of entries, without an object for each. */
    static String jar(Path jar) throws IOException {
        try (FileChannel file = FileChannel.open(jar)) {
            ByteBuffer end = read(file, Math.max(0, file.size() - END_BYTES), END_BYTES);
            int size = end.getInt(END_SIZE);
            int start = end.getInt(END_START);
            if (end.getInt(0) != END_MARK || start < 0 || size < 0 || start + (long) size > file.size() - END_BYTES) {
                return entries(jar);
            }
            ByteBuffer list = read(file, start, size);
            return size + " " + sum(new CRC32(), list) + " " + sum(new CRC32C(), list);
        }
    }

    private static ByteBuffer read(FileChannel file, long start, int size) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
        for (int read = 0; bytes.hasRemaining() && read >= 0; ) {
            read = file.read(bytes, start + bytes.position());
        }
        return bytes.clear();
    }

    private static long sum(Checksum sum, ByteBuffer bytes) {
        sum.update(bytes.array());
        return sum.getValue();
    }

    /** For a jar with a comment at its end, or one beyond the limits of the format's first version. */
    private static String entries(Path jar) throws IOException {
        try (ZipFile file = new ZipFile(jar.toFile())) {
            return file.stream()
                    .map(entry -> entry.getName() + " " + checksum(entry))
                    .sorted()
                    .collect(Collectors.joining("\n"));
        }
    }

    private static String checksum(ZipEntry entry) {
        return entry.getSize() + " " + entry.getCrc();
    }

    private static String files(Path directory) throws IOException {
        List<Path> all;
        try (Stream<Path> walk = Files.walk(directory)) {
            all = walk.filter(file -> file.toString().endsWith(".class"))
                    .sorted()
                    .toList();
        }
        StringBuilder text = new StringBuilder();
        for (Path file : all) {
            text.append(directory.relativize(file)).append(' ');
            text.append(Files.size(file)).append(' ');
            text.append(Files.getLastModifiedTime(file)).append('\n');
        }
        return text.toString();
    }
}
