package org.dronewatch.run.store;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.SahCost;
import org.dronewatch.setting.input.FileHash;

/**
 * The name of something prepared, with the SHA-256 of everything that it depends on: the bytes of files, settings, the
 * format of the store, this program's code and the machine that runs it.
 *
 * @param kind kind of the thing that was prepared, in lower-case letters
 * @param sha256 64 hexadecimal digits in lower case
 */
public record StoreKey(String kind, String sha256) {
    private static final int CHUNK = 1 << 15;

    /**
     * The key of something made from files.
     *
     * @param files the files as they were when they were read
     * @param parts everything else that the thing depends on, hashed as text
     */
    public static StoreKey of(String kind, List<FileHash> files, Object... parts) {
        MessageDigest digest = newDigest(kind);
        for (FileHash file : files) {
            add(file.file(), digest);
            add(file.sha256(), digest);
        }
        for (Object part : parts) {
            add(String.valueOf(part), digest);
        }
        return finished(kind, digest);
    }

    /** A hash of a mesh: of its triangles' corners and materials. */
    public static String hash(TriangleMesh mesh) {
        MessageDigest digest = newDigest("mesh");
        addCorners(mesh, digest);
        int[] materials = mesh.materials();
        addAll(materials.length, (bytes, at, count) -> bytes.asIntBuffer().put(materials, at, count), digest);
        mesh.materialNames().forEach(name -> add(name, digest));
        return finished("mesh", digest).sha256();
    }

    /** The key of the tree over a mesh: it depends on the triangles' corners alone. */
    static StoreKey of(String kind, TriangleMesh mesh, SahCost costs) {
        MessageDigest digest = newDigest(kind);
        add(String.valueOf(costs), digest);
        addCorners(mesh, digest);
        return finished(kind, digest);
    }

    private static void addCorners(TriangleMesh mesh, MessageDigest digest) {
        add(mesh.vertexCount() + " vertices, " + mesh.triangleCount() + " triangles", digest);
        float[] vertices = mesh.vertices();
        addAll(vertices.length, (bytes, at, count) -> bytes.asFloatBuffer().put(vertices, at, count), digest);
        int[] corners = mesh.corners();
        addAll(corners.length, (bytes, at, count) -> bytes.asIntBuffer().put(corners, at, count), digest);
    }

    /** Adds an array of numbers of four bytes each, part by part. */
    private static void addAll(int length, Part part, MessageDigest digest) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * CHUNK).order(ByteOrder.LITTLE_ENDIAN);
        for (int at = 0; at < length; at += CHUNK) {
            int count = Math.min(CHUNK, length - at);
            bytes.clear();
            part.put(bytes, at, count);
            digest.update(bytes.limit(Integer.BYTES * count));
        }
    }

    private interface Part {
        void put(ByteBuffer target, int at, int count);
    }

    private static MessageDigest newDigest(String kind) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            add("format " + StoredForms.VERSION + " of " + kind, digest);
            add(CodeStamp.text(), digest);
            return digest;
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java platform has SHA-256", e);
        }
    }

    /** Adds a text with its length, so that no two lists of texts look alike. */
    private static void add(String text, MessageDigest digest) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        digest.update(ByteBuffer.allocate(Integer.BYTES).putInt(bytes.length).flip());
        digest.update(bytes);
    }

    private static StoreKey finished(String kind, MessageDigest digest) {
        return new StoreKey(kind, HexFormat.of().formatHex(digest.digest()));
    }

    /** The name of its file. */
    String fileName() {
        return kind + "-" + sha256 + SiteStore.SUFFIX;
    }
}
