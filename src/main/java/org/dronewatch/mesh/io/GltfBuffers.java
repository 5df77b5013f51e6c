package org.dronewatch.mesh.io;

import java.io.IOException;
import java.io.InputStream;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.setting.input.HeapBudget;
import tools.jackson.databind.JsonNode;

/**
 * The numbers of a glTF file: buffers, views of them, and accessors, whose bounds are checked before anything is read.
 */
final class GltfBuffers {
    private static final int BYTE = 5120;
    private static final int UNSIGNED_BYTE = 5121;
    private static final int SHORT = 5122;
    private static final int UNSIGNED_SHORT = 5123;
    private static final int UNSIGNED_INT = 5125;
    private static final int FLOAT = 5126;

    private final ModelFile file;
    private final JsonNode root;
    private final HeapBudget budget;
    private final List<ByteBuffer> buffers = new ArrayList<>();
    private final List<FileHash> files = new ArrayList<>();

    /**
     * The buffers of a file.
     *
     * @param binary what follows the JSON in a GLB file; empty for none
     * @param budget memory for the buffers
     */
    GltfBuffers(ModelFile file, JsonNode root, byte[] binary, HeapBudget budget) throws IOException {
        this.file = file;
        this.root = root;
        this.budget = budget;
        for (JsonNode buffer : root.path("buffers")) {
            JsonNode uri = buffer.path("uri");
            byte[] bytes = uri.isMissingNode() ? binary : bytes(uri.asString(""));
            long stated = buffer.path("byteLength").asLong(-1);
            if (stated < 0 || stated > bytes.length) {
                throw wrong("buffer " + buffers.size() + " states " + stated + " bytes but has " + bytes.length);
            }
            buffers.add(ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN));
        }
    }

    /** The files beside it that were read. */
    List<FileHash> files() {
        return files;
    }

    private byte[] bytes(String uri) throws IOException {
        if (uri.startsWith("data:")) {
            int comma = uri.indexOf(',');
            if (comma < 0 || !uri.substring(0, comma).endsWith(";base64")) {
                throw wrong("the data of a buffer is not base64");
            }
            budget.take(uri.length());
            try {
                return Base64.getDecoder().decode(uri.substring(comma + 1));
            } catch (IllegalArgumentException e) {
                throw new InputException(file.name() + ": a buffer is not base64: " + e.getMessage(), e);
            }
        }
        String name;
        try {
            name = URLDecoder.decode(uri.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException e) {
            throw new InputException(
                    file.name() + ": buffer '" + PlainText.value(uri) + "' is not the name of a file", e);
        }
        ModelFile beside;
        try {
            beside = file.beside(name, ModelFile.MAX_BYTES);
            files.add(beside.hash());
        } catch (InputException e) {
            throw new InputException(file.name() + ": buffer '" + PlainText.value(uri) + "' " + e.getMessage(), e);
        }
        // While it is read, there are two copies of it.
        budget.take(2 * beside.size());
        try (InputStream in = beside.open()) {
            return in.readAllBytes();
        }
    }

    private InputException wrong(String what) {
        return new InputException(file.name() + ": " + what);
    }

    /**
     * Values in a buffer, read one at a time: the number of values that a file states does not cause any memory to be
     * allocated.
     *
     * @param count number of values
     * @param start where the first one begins in the buffer
     * @param stride distance from one to the next, bytes
     */
    record Accessor(
            ByteBuffer buffer, int count, long start, long stride, int component, int size, boolean isNormalized) {
        /** A component of a value. */
        double at(int value, int axis) {
            return value(buffer, (int) (start + value * stride + (long) size * axis), component, isNormalized);
        }
    }

    /**
     * An accessor, all of whose values lie within their buffer.
     *
     * @param number of the accessor
     * @param type that it must have, such as {@code VEC3}
     * @param components of that type
     */
    Accessor accessor(int number, String type, int components) {
        JsonNode accessor = root.path("accessors").path(number);
        String name = "accessor " + number;
        if (!accessor.path("type").asString("").equals(type)) {
            throw wrong(name + " is '" + PlainText.value(accessor.path("type").asString("")) + "' but must be " + type);
        }
        if (accessor.has("sparse")) {
            throw wrong(
                    name + " is sparse, which is not supported: 'gltf-transform copy' writes a file that can be read");
        }
        int component = accessor.path("componentType").asInt(0);
        int size = size(component, name);
        long count = accessor.path("count").asLong(-1);
        JsonNode view =
                root.path("bufferViews").path(accessor.path("bufferView").asInt(-1));
        int inBuffer = view.path("buffer").asInt(-1);
        if (inBuffer < 0 || inBuffer >= buffers.size()) {
            throw wrong(name + " has no buffer");
        }
        long start =
                view.path("byteOffset").asLong(0) + accessor.path("byteOffset").asLong(0);
        long stride = view.path("byteStride").asLong((long) size * components);
        long room = Math.min(
                buffers.get(inBuffer).limit(),
                view.path("byteOffset").asLong(0) + view.path("byteLength").asLong(0));
        boolean isInside = count >= 0
                && count <= room
                && start >= 0
                && stride >= (long) size * components
                && stride <= 256
                && (count == 0 || start + (count - 1) * stride + (long) size * components <= room);
        if (!isInside) {
            throw wrong(name + " of " + count + " values does not lie within its buffer");
        }
        boolean isNormalized = accessor.path("normalized").asBoolean(false);
        return new Accessor(buffers.get(inBuffer), (int) count, start, stride, component, size, isNormalized);
    }

    private int size(int component, String name) {
        return switch (component) {
            case BYTE, UNSIGNED_BYTE -> 1;
            case SHORT, UNSIGNED_SHORT -> 2;
            case UNSIGNED_INT, FLOAT -> 4;
            default -> throw wrong(name + " has components of type " + component + " but must have 5120 to 5126");
        };
    }

    /** Normalised whole numbers represent 0 to 1, or -1 to 1 (glTF 2.0, section 3.6.2.2). */
    private static double value(ByteBuffer buffer, int at, int component, boolean isNormalized) {
        return switch (component) {
            case BYTE -> isNormalized ? Math.max(buffer.get(at) / 127.0, -1.0) : buffer.get(at);
            case UNSIGNED_BYTE -> Byte.toUnsignedInt(buffer.get(at)) / (isNormalized ? 255.0 : 1.0);
            case SHORT -> isNormalized ? Math.max(buffer.getShort(at) / 32767.0, -1.0) : buffer.getShort(at);
            case UNSIGNED_SHORT -> Short.toUnsignedInt(buffer.getShort(at)) / (isNormalized ? 65535.0 : 1.0);
            case UNSIGNED_INT -> Integer.toUnsignedLong(buffer.getInt(at));
            default -> buffer.getFloat(at);
        };
    }
}
