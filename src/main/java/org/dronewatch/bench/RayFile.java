package org.dronewatch.bench;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.RegularFile;

/**
 * Files of rays and hits, all little-endian. Rays: an int32 count, then six float32 per ray (origin, direction). Hits:
 * a float32 distance (infinity for none) and an int32 triangle (-1 for none) per ray.
 */
public final class RayFile {
    private static final int RAY_BYTES = RaySet.FLOATS * Float.BYTES;
    private static final int MAX_RAYS = 100_000_000;

    private RayFile() {}

    /**
     * Reads a file of rays.
     *
     * @return six numbers for each ray: origin, then direction
     * @throws InputException when the file is missing, its size does not match its count, or a ray is invalid
     */
    public static float[] read(Path file) {
        String obstacle = RegularFile.obstacle(file);
        if (!obstacle.isEmpty()) {
            throw new InputException("ray file " + PlainText.value(file) + " cannot be read: " + obstacle);
        }
        try (InputStream stream = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
            int count = ByteBuffer.wrap(stream.readNBytes(Integer.BYTES))
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .getInt();
            long expected = Integer.BYTES + (long) count * RAY_BYTES;
            if (count < 1 || count > MAX_RAYS || Files.size(file) != expected) {
                throw new InputException(file + ": states a count of " + count + " rays and has " + Files.size(file)
                        + " bytes; it must hold 1 to " + MAX_RAYS + " rays: 4 bytes, and 24 for each ray");
            }
            float[] rays = new float[count * RaySet.FLOATS];
            ByteBuffer buffer = ByteBuffer.allocate(RAY_BYTES).order(ByteOrder.LITTLE_ENDIAN);
            for (int ray = 0; ray < count; ray++) {
                stream.readNBytes(buffer.array(), 0, RAY_BYTES);
                buffer.rewind().asFloatBuffer().get(rays, ray * RaySet.FLOATS, RaySet.FLOATS);
                check(file, ray, rays);
            }
            return rays;
        } catch (BufferUnderflowException e) {
            throw new InputException(file + ": is shorter than the 4 bytes of a count", e);
        } catch (IOException e) {
            throw new InputException("ray file " + PlainText.value(file) + " cannot be read: " + e.getMessage(), e);
        }
    }

    private static void check(Path file, int ray, float[] rays) {
        double squaredLength = 0.0;
        for (int i = 0; i < RaySet.FLOATS; i++) {
            float value = rays[ray * RaySet.FLOATS + i];
            if (!Float.isFinite(value)) {
                throw new InputException(file + ": ray " + ray + " has the number " + value + ", which must be finite");
            }
            squaredLength += i < 3 ? 0.0 : (double) value * value;
        }
        if (!(squaredLength > 0.0)) {
            throw new InputException(file + ": ray " + ray + " has no direction");
        }
    }

    /** Writes hits, a distance and a triangle for each ray. */
    public static void writeHits(OutputStream stream, float[] distances, int[] triangles) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(Float.BYTES + Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < distances.length; i++) {
            buffer.clear().putFloat(distances[i]).putInt(triangles[i]);
            stream.write(buffer.array());
        }
    }
}
