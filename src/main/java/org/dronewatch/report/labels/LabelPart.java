package org.dronewatch.report.labels;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * What one camera saw in one run, until it is known how many images come before: one file of images and one of
 * annotations, one object per line, without their numbers. Each annotation's line begins with the index of its image in
 * this part.
 */
final class LabelPart implements Closeable {
    private static final JsonMapper MAPPER = JsonMapper.builder().build();
    private static final char SEPARATOR = ' ';

    private final Path imageFile;
    private final Path annotationFile;
    private final BufferedWriter images;
    private final BufferedWriter annotations;
    private long count;

    /** An empty part in two new files. */
    LabelPart(Path imageFile, Path annotationFile) throws IOException {
        this.imageFile = imageFile;
        this.annotationFile = annotationFile;
        this.images = Files.newBufferedWriter(imageFile, StandardCharsets.UTF_8);
        BufferedWriter second = null;
        try {
            second = Files.newBufferedWriter(annotationFile, StandardCharsets.UTF_8);
        } finally {
            if (second == null) {
                images.close();
            }
        }
        this.annotations = second;
    }

    /** Adds an image with its annotations. */
    void add(ObjectNode image, List<ObjectNode> seen) throws IOException {
        images.write(MAPPER.writeValueAsString(image));
        images.write('\n');
        for (ObjectNode annotation : seen) {
            annotations.write(Long.toString(count));
            annotations.write(SEPARATOR);
            annotations.write(MAPPER.writeValueAsString(annotation));
            annotations.write('\n');
        }
        count++;
    }

    /** Number of images. */
    long images() {
        return count;
    }

    /**
     * Copies the images as items of a JSON list, numbered from 1 over all parts.
     *
     * @param before number of images in the parts before
     * @return number of images up to here
     */
    long copyImages(BufferedWriter coco, long before) throws IOException {
        long number = before;
        try (BufferedReader lines = Files.newBufferedReader(imageFile, StandardCharsets.UTF_8)) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                number++;
                coco.write(number == 1 ? "\n" : ",\n");
                coco.write("{\"id\":" + number + ",");
                coco.write(line, 1, line.length() - 1);
            }
        }
        return number;
    }

    /**
     * Copies the annotations likewise.
     *
     * @param before number of annotations in the parts before
     * @param imagesBefore number of images in the parts before
     * @return number of annotations up to here
     */
    long copyAnnotations(BufferedWriter coco, long before, long imagesBefore) throws IOException {
        long number = before;
        try (BufferedReader lines = Files.newBufferedReader(annotationFile, StandardCharsets.UTF_8)) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                int end = line.indexOf(SEPARATOR);
                long image = imagesBefore + Long.parseLong(line, 0, end, 10) + 1;
                number++;
                coco.write(number == 1 ? "\n" : ",\n");
                coco.write("{\"id\":" + number + ",\"image_id\":" + image + ",");
                coco.write(line, end + 2, line.length() - end - 2);
            }
        }
        return number;
    }

    /** Removes the files. */
    void delete() throws IOException {
        Files.delete(imageFile);
        Files.delete(annotationFile);
    }

    @Override
    public void close() throws IOException {
        try (images) {
            annotations.close();
        }
    }
}
