package org.dronewatch.run.store;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.dronewatch.setting.input.FileHash;

/**
 * Identifies the code that prepares sites: what another build, another Java or another kind of processor prepared is
 * not used, since its results may differ in the last bit.
 */
final class CodeStamp {
    /** Holds the stamp, which is made by the first thread that needs it, not by the one that calls {@code prepare}. */
    private static final class Made {
        static final String TEXT = FileHash.ofText(System.getProperty("java.vm.name")
                + System.getProperty("java.vm.version")
                + System.getProperty("os.arch")
                + code());
    }

    private CodeStamp() {}

    static String text() {
        return Made.TEXT;
    }

    /** Makes the stamp in the background: listing thousands of classes takes as long as reading a model. */
    static void prepare() {
        CompletableFuture.runAsync(CodeStamp::text);
    }

    /** The entries of the program's jar with their checksums, or the files of a directory with their times. */
    private static String code() {
        try {
            CodeSource source = CodeStamp.class.getProtectionDomain().getCodeSource();
            Path path = Path.of(source.getLocation().toURI());
            return Files.isDirectory(path) ? files(path) : entries(path);
        } catch (IOException | URISyntaxException | RuntimeException e) {
            // Unknown code agrees with nothing, not even with itself.
            return UUID.randomUUID().toString();
        }
    }

    static String entries(Path jar) throws IOException {
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
