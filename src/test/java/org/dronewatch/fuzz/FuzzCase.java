package org.dronewatch.fuzz;

import java.io.IOException;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * One input of the program: files, things that are no plain files, and a command line in which {@code {}} stands for
 * the directory of the files. It is stored as a directory: the files, and {@value #PROPERTIES} with the rest.
 *
 * @param what what it is, for a person
 * @param files contents by path below the directory
 * @param specials what {@link SpecialFile} makes, by path below the directory
 * @param arguments the command line; may be empty where no command is run
 */
public record FuzzCase(String what, Map<String, byte[]> files, Map<String, String> specials, List<String> arguments) {
    /** The file beside the inputs that holds all that is not a file. */
    public static final String PROPERTIES = "case.properties";

    /** What stands for the directory of the files in arguments and contents of links. */
    public static final String DIRECTORY = "{}";

    private static final String SPECIAL = "special.";
    private static final String ARGUMENT_SEPARATOR = " | ";

    /** Copies the collections, sorted by path. */
    public FuzzCase {
        files = new TreeMap<>(files);
        specials = new TreeMap<>(specials);
        arguments = List.copyOf(arguments);
    }

    /** A case of one scene file or model and a command line. */
    public static FuzzCase of(String what, String file, String text, String... arguments) {
        return new FuzzCase(what, Map.of(file, text.getBytes(StandardCharsets.UTF_8)), Map.of(), List.of(arguments));
    }

    /** The same with one more file, or another content of one. */
    public FuzzCase with(String file, String text) {
        return with(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /** The same with one more file, or another content of one. */
    public FuzzCase with(String file, byte[] content) {
        Map<String, byte[]> changed = new LinkedHashMap<>(files);
        changed.put(file, content);
        return new FuzzCase(what, changed, specials, arguments);
    }

    /** The same with one more thing that is no plain file; see {@link SpecialFile}. */
    public FuzzCase withSpecial(String path, String kind) {
        Map<String, String> changed = new LinkedHashMap<>(specials);
        changed.put(path, kind);
        return new FuzzCase(what, files, changed, arguments);
    }

    /** The same with another command line. */
    public FuzzCase withArguments(List<String> others) {
        return new FuzzCase(what, files, specials, others);
    }

    /** The content of a file as text. */
    public String text(String file) {
        return new String(files.get(file), StandardCharsets.UTF_8);
    }

    /** How many bytes its files have. */
    public long bytes() {
        return files.values().stream().mapToLong(content -> content.length).sum();
    }

    /** The command line for files in a directory. */
    public String[] argumentsIn(Path directory) {
        return arguments.stream()
                .map(argument -> argument.replace(DIRECTORY, directory.toString()))
                .toArray(String[]::new);
    }

    /** Makes the files, and what is no plain file. */
    public void writeFiles(Path directory) throws IOException {
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path path = directory.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.write(path, file.getValue());
        }
        for (Map.Entry<String, String> special : specials.entrySet()) {
            SpecialFile.make(special.getValue(), directory.resolve(special.getKey()), directory);
        }
    }

    /**
     * Stores it, with further properties, as a directory that {@link #readFrom} reads. What is no plain file is
     * described, not made.
     */
    public void store(Path directory, Map<String, String> further) throws IOException {
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path path = directory.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.write(path, file.getValue());
        }
        Properties properties = new Properties();
        properties.setProperty("what", what);
        properties.setProperty("arguments", String.join(ARGUMENT_SEPARATOR, arguments));
        specials.forEach((path, kind) -> properties.setProperty(SPECIAL + path, kind));
        further.forEach(properties::setProperty);
        try (Writer writer = Files.newBufferedWriter(directory.resolve(PROPERTIES))) {
            properties.store(writer, null);
        }
    }

    /** Reads the properties of a stored case. */
    public static Properties properties(Path directory) throws IOException {
        Properties properties = new Properties();
        try (Reader reader = Files.newBufferedReader(directory.resolve(PROPERTIES))) {
            properties.load(reader);
        }
        return properties;
    }

    /** Reads a stored case. */
    public static FuzzCase readFrom(Path directory) throws IOException {
        Properties properties = properties(directory);
        Map<String, byte[]> files = new LinkedHashMap<>();
        try (Stream<Path> found = Files.walk(directory)) {
            for (Path path : found.filter(Files::isRegularFile).toList()) {
                files.put(directory.relativize(path).toString().replace('\\', '/'), Files.readAllBytes(path));
            }
        }
        files.remove(PROPERTIES);
        files.remove("README.txt");
        Map<String, String> specials = new LinkedHashMap<>();
        for (String name : properties.stringPropertyNames()) {
            if (name.startsWith(SPECIAL)) {
                specials.put(name.substring(SPECIAL.length()), properties.getProperty(name));
            }
        }
        String arguments = properties.getProperty("arguments", "");
        return new FuzzCase(
                properties.getProperty("what", directory.getFileName().toString()),
                files,
                specials,
                arguments.isEmpty() ? List.of() : List.of(arguments.split(" \\| ", -1)));
    }
}
