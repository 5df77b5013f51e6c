package org.dronewatch.world;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import org.dronewatch.setting.InputException;

/** A model file on disk or in the jar, and the files beside it. */
final class ModelFile {
    /** The largest file that is read, in bytes. */
    static final long MAX_BYTES = 1L << 30;

    private static final String RESOURCES = "/models/";

    private final String name;
    private final Path path;
    private final URL resource;

    private ModelFile(String name, Path path, URL resource) {
        this.name = name;
        this.path = path;
        this.resource = resource;
    }

    /**
     * Finds a model.
     *
     * @param directory where relative paths start
     * @param file a path, or a packaged name
     * @throws InputException when there is no such file, or it is larger than {@link #MAX_BYTES}
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
        if (!Files.isRegularFile(path)) {
            throw new InputException(
                    "model file " + path + " does not exist" + (Files.exists(path) ? " as a file" : ""));
        }
        return onDisk(path);
    }

    private static ModelFile onDisk(Path path) {
        try {
            long size = Files.size(path);
            if (size > MAX_BYTES) {
                throw new InputException(path + ": " + size + " bytes, but a model file may have at most " + MAX_BYTES);
            }
        } catch (IOException e) {
            throw new InputException("model file " + path + " cannot be read: " + e.getMessage(), e);
        }
        return new ModelFile(path.toString(), path, null);
    }

    private static Optional<ModelFile> resource(String plainName) {
        boolean plain = plainName.matches("[\\w.-]+") && !plainName.contains("..");
        URL url = plain ? ModelFile.class.getResource(RESOURCES + plainName) : null;
        return Optional.ofNullable(url).map(found -> new ModelFile(plainName, null, found));
    }

    /**
     * A file in the same directory, or empty when there is none or its name leads elsewhere: a model never reads files
     * outside its own directory.
     */
    Optional<ModelFile> beside(String sibling) {
        if (path == null) {
            return resource(sibling);
        }
        try {
            Path directory = path.toAbsolutePath().normalize().getParent();
            Path other = path.resolveSibling(sibling).toAbsolutePath().normalize();
            return directory != null
                            && other.startsWith(directory)
                            && Files.isRegularFile(other)
                            && Files.size(other) <= MAX_BYTES
                    ? Optional.of(new ModelFile(other.toString(), other, null))
                    : Optional.empty();
        } catch (InvalidPathException | IOException e) {
            return Optional.empty();
        }
    }

    /** What messages call the file. */
    String name() {
        return name;
    }

    InputStream open() throws IOException {
        return new BufferedInputStream(path != null ? Files.newInputStream(path) : resource.openStream());
    }
}
