package org.dronewatch.mesh.io;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Pattern;
import org.dronewatch.geo.Origin;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.RegularFile;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.setting.input.LinkOut;

/**
 * A model file on disk or in the jar, and the files beside it. Only regular files of bounded size are read; a byte
 * order mark at the beginning of a text is skipped.
 */
public final class ModelFile {
    /** The largest model that is read, in bytes. */
    public static final long MAX_BYTES = 1L << 30;

    /** The largest file beside a model that is read, in bytes. */
    public static final long MAX_BYTES_BESIDE = 1L << 24;

    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};

    private static final String RESOURCES = "/models/";
    private static final Pattern DRIVE = Pattern.compile("[A-Za-z]:");
    private static final String LEADS_ELSEWHERE = "leads out of the model's directory";

    private final String name;
    private final Path path;
    private final URL resource;
    private final Optional<Origin> sceneOrigin;

    private ModelFile(String name, Path path, URL resource) {
        this(name, path, resource, Optional.empty());
    }

    private ModelFile(String name, Path path, URL resource, Optional<Origin> sceneOrigin) {
        this.name = name;
        this.path = path;
        this.resource = resource;
        this.sceneOrigin = sceneOrigin;
    }

    /** This file as a model of a scene whose origin lies there, which coordinates of a national grid need. */
    ModelFile inScene(Optional<Origin> origin) {
        return new ModelFile(name, path, resource, origin);
    }

    /**
     * The placement of its coordinates in the scene.
     *
     * @throws InputException when they are those of a national grid, and the scene's origin is not known
     */
    Placement placement(ModelSettings settings) {
        return new Placement(settings, sceneOrigin);
    }

    /**
     * Finds a model.
     *
     * @param directory directory against which relative paths are resolved, that of a scene file or empty for the
     *     working directory; symbolic links may not lead out of the directory of a scene file
     * @param file a path, or a packaged name
     * @throws InputException if there is no such file, or it is larger than {@link #MAX_BYTES}
     */
    static ModelFile find(Path directory, String file) {
        if (file.startsWith(ModelSettings.PACKAGED)) {
            String plain = file.substring(ModelSettings.PACKAGED.length());
            return resource(plain).orElseThrow(() -> new InputException("no packaged model '" + plain + "'"));
        }
        Path path;
        try {
            path = directory.resolve(file);
        } catch (InvalidPathException e) {
            throw new InputException("model file '" + file + "' is not a path: " + e.getReason(), e);
        }
        String problem = wrongWith(path, MAX_BYTES);
        if (!problem.isEmpty()) {
            // A relative path says little to those who start programs in another directory than they think.
            throw new InputException(
                    "model file " + PlainText.value(path.toAbsolutePath().normalize()) + " " + problem);
        }
        LinkOut.refuse(directory, path, "model file");
        return new ModelFile(file, path, null);
    }

    /** What is wrong with a file, as the end of a sentence; empty for nothing. */
    private static String wrongWith(Path path, long maxBytes) {
        if (!Files.exists(path)) {
            return "does not exist";
        }
        String obstacle = RegularFile.obstacle(path);
        if (!obstacle.isEmpty()) {
            return obstacle;
        }
        try {
            long size = Files.size(path);
            return size <= maxBytes ? "" : "has " + size + " bytes, but may have at most " + maxBytes;
        } catch (IOException e) {
            return "cannot be read: " + e.getMessage();
        }
    }

    private static Optional<ModelFile> resource(String plainName) {
        boolean plain = plainName.matches("[\\w.-]+") && !plainName.contains("..");
        URL url = plain ? ModelFile.class.getResource(RESOURCES + plainName) : null;
        return Optional.ofNullable(url).map(found -> new ModelFile(plainName, null, found));
    }

    /**
     * A file in the same directory or below it: a model never reads files elsewhere, not even through symbolic links.
     * Backslashes separate directories, as on Windows.
     *
     * @throws InputException whose message is the last part of a sentence, when the name leads elsewhere or there is no
     *     such file
     */
    public ModelFile beside(String sibling) {
        return beside(sibling, MAX_BYTES_BESIDE);
    }

    /** As {@link #beside(String)}, with another limit, bytes. */
    ModelFile beside(String sibling, long maxBytes) {
        if (path == null) {
            return resource(sibling).orElseThrow(() -> new InputException("is not next to the model"));
        }
        try {
            Path other = inDirectory(sibling.replace('\\', '/'));
            String problem = wrongWith(other, maxBytes);
            if (!problem.isEmpty()) {
                throw new InputException(problem);
            }
            return new ModelFile(other.toString(), other, null);
        } catch (InvalidPathException | IOException e) {
            throw new InputException("cannot be read: " + e.getMessage(), e);
        }
    }

    private Path inDirectory(String sibling) throws IOException {
        Path directory = path.toAbsolutePath().resolveSibling("").normalize();
        Path other = directory.resolve(sibling).normalize();
        if (sibling.startsWith("/") || DRIVE.matcher(sibling).lookingAt() || !other.startsWith(directory)) {
            throw new InputException(LEADS_ELSEWHERE);
        }
        if (!Files.exists(other)) {
            throw new InputException("is not next to the model");
        }
        if (!other.toRealPath().startsWith(directory.toRealPath())) {
            throw new InputException(LEADS_ELSEWHERE);
        }
        return other;
    }

    /** The file's name in messages. */
    public String name() {
        return name;
    }

    /** How many bytes it has. */
    long size() throws IOException {
        if (path != null) {
            return Files.size(path);
        }
        try (InputStream bytes = open()) {
            return bytes.skip(MAX_BYTES);
        }
    }

    /** The hash of the file's bytes. */
    public FileHash hash() {
        try (InputStream bytes = open()) {
            return FileHash.of(shortName(), bytes);
        } catch (IOException e) {
            throw new InputException("model file " + name + " cannot be read: " + e.getMessage(), e);
        }
    }

    private String shortName() {
        return path == null ? name : String.valueOf(path.getFileName());
    }

    /** The file's text in UTF-8 without a byte order mark. */
    public Reader text() throws IOException {
        InputStream bytes = open();
        bytes.mark(BYTE_ORDER_MARK.length);
        if (!Arrays.equals(bytes.readNBytes(BYTE_ORDER_MARK.length), BYTE_ORDER_MARK)) {
            bytes.reset();
        }
        return new InputStreamReader(bytes, StandardCharsets.UTF_8);
    }

    /** The file's bytes, buffered. */
    public InputStream open() throws IOException {
        return new BufferedInputStream(path != null ? Files.newInputStream(path) : resource.openStream());
    }
}
