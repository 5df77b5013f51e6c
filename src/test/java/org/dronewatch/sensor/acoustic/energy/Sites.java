package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;

/** Simple sites, one-band sources and readings for tests of the energy model. */
final class Sites {
    /** Sound power level of every source, dB. */
    static final double LW = 100.0;

    /** The band of 63 Hz, in which the air takes next to nothing. */
    static final int LOWEST = 0;

    private Sites() {}

    /** A box from one corner to another. */
    static TriangleMesh box(double x0, double y0, double z0, double x1, double y1, double z1) {
        float[] vertices = new float[24];
        for (int i = 0; i < 8; i++) {
            vertices[3 * i] = (float) ((i & 1) == 0 ? x0 : x1);
            vertices[3 * i + 1] = (float) ((i & 2) == 0 ? y0 : y1);
            vertices[3 * i + 2] = (float) ((i & 4) == 0 ? z0 : z1);
        }
        int[] corners = {
            0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5
        };
        return TriangleMesh.of(vertices, corners);
    }

    /** A room from the origin to a corner. */
    static TriangleMesh room(double x, double y, double z) {
        return box(0, 0, 0, x, y, z);
    }

    /** A rectangle in a plane of constant x, y or z (axis 0, 1, 2); the other two axes follow in turn. */
    static TriangleMesh wall(int axis, double at, double u0, double u1, double v0, double v1) {
        double[][] corners = {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
        float[] vertices = new float[12];
        for (int i = 0; i < 4; i++) {
            vertices[3 * i + axis] = (float) at;
            vertices[3 * i + (axis + 1) % 3] = (float) corners[i][0];
            vertices[3 * i + (axis + 2) % 3] = (float) corners[i][1];
        }
        return TriangleMesh.of(vertices, new int[] {0, 1, 2, 0, 2, 3});
    }

    /** A level square about the z axis. */
    static TriangleMesh square(double half, double z) {
        return wall(2, z, -half, half, -half, half);
    }

    static World world(TriangleMesh mesh, SurfaceMaterial surface) {
        return new World(KDTree.of(mesh), BackgroundNoise.of(20), List.of(surface), Atmosphere.STANDARD);
    }

    /** Meshes of one surface each. */
    static World world(List<TriangleMesh> meshes, List<SurfaceMaterial> surfaces) {
        List<TriangleMesh> named = new ArrayList<>();
        for (int i = 0; i < meshes.size(); i++) {
            named.add(named(meshes.get(i), surfaces.get(i).name()));
        }
        return new World(KDTree.of(World.merge(named)), BackgroundNoise.of(20), surfaces, Atmosphere.STANDARD);
    }

    private static TriangleMesh named(TriangleMesh mesh, String material) {
        float[] vertices = new float[3 * mesh.vertexCount()];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = mesh.vertexCoordinate(i / 3, i % 3);
        }
        int[] corners = new int[3 * mesh.triangleCount()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = mesh.vertexIndex(i / 3, i % 3);
        }
        int[] numbers = IntStream.range(0, mesh.triangleCount()).toArray();
        return new TriangleMesh(vertices, corners, new int[numbers.length], numbers, List.of(material));
    }

    /** Nothing near. */
    static World open() {
        return world(square(1, -1e6), SurfaceMaterial.uniform("any", 0.5, 0));
    }

    /** 100 dB of sound power in one band. */
    static SoundSource sound(Position place, int band) {
        return sound(place, band, Directivity.OMNIDIRECTIONAL);
    }

    static SoundSource sound(Position place, int band, Directivity directivity) {
        List<Double> power = new ArrayList<>();
        for (int i = 0; i < OctaveBands.COUNT; i++) {
            power.add(i == band ? LW : Double.NEGATIVE_INFINITY);
        }
        return new SoundSource(place, power, directivity);
    }

    /** 100 dB of sound power in every band. */
    static SoundSource broadband(Position place) {
        return new SoundSource(place, Collections.nCopies(OctaveBands.COUNT, LW), Directivity.OMNIDIRECTIONAL);
    }

    static EnergyReading read(EnergyModel model, World world, SoundSource source, Position sensor, long seed) {
        return new EnergyTracer(model, sensor, 0.4, world).trace(source, new SplittableRandom(seed), RayRecorder.NONE);
    }

    /** Traces all of the rays, and follows them nearly to their ends, for sound of one band. */
    static EnergyReading readInFull(
            World world, Position source, Position sensor, double radius, int rays, int band, long seed) {
        return new EnergyTracer(
                        EnergyModel.DEFAULT.withRays(rays).withAccuracy(0.0).withRoulette(1e-3), sensor, radius, world)
                .trace(sound(source, band), new SplittableRandom(seed), RayRecorder.NONE);
    }

    /** A square of terrain of cells of some size about the origin. */
    static TriangleMesh terrain(double half, double cell, DoubleBinaryOperator height) {
        int count = (int) Math.round(2 * half / cell);
        float[] vertices = new float[3 * (count + 1) * (count + 1)];
        int[] corners = new int[6 * count * count];
        for (int j = 0; j <= count; j++) {
            for (int i = 0; i <= count; i++) {
                int at = 3 * (j * (count + 1) + i);
                vertices[at] = (float) (i * cell - half);
                vertices[at + 1] = (float) (j * cell - half);
                vertices[at + 2] = (float) height.applyAsDouble(vertices[at], vertices[at + 1]);
            }
        }
        for (int j = 0; j < count; j++) {
            for (int i = 0; i < count; i++) {
                int a = j * (count + 1) + i;
                int c = a + count + 1;
                System.arraycopy(new int[] {a, a + 1, c + 1, a, c + 1, c}, 0, corners, 6 * (j * count + i), 6);
            }
        }
        return TriangleMesh.of(vertices, corners);
    }

    /** A mesh with all its corners moved. */
    static TriangleMesh turned(TriangleMesh mesh, UnaryOperator<Position> turn) {
        float[] vertices = new float[3 * mesh.vertexCount()];
        for (int i = 0; i < mesh.vertexCount(); i++) {
            Position at = turn.apply(new Position(
                    mesh.vertexCoordinate(i, 0), mesh.vertexCoordinate(i, 1), mesh.vertexCoordinate(i, 2)));
            vertices[3 * i] = (float) at.x();
            vertices[3 * i + 1] = (float) at.y();
            vertices[3 * i + 2] = (float) at.z();
        }
        int[] corners = new int[3 * mesh.triangleCount()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = mesh.vertexIndex(i / 3, i % 3);
        }
        return TriangleMesh.of(vertices, corners);
    }

    /** A rotation, uniform over all attitudes, by a random quaternion. */
    static UnaryOperator<Position> attitude(SplittableRandom random) {
        double a = Math.sqrt(1 - random.nextDouble());
        double b = Math.sqrt(1 - a * a);
        double p = 2 * Math.PI * random.nextDouble();
        double q = 2 * Math.PI * random.nextDouble();
        double w = a * Math.cos(p);
        Position axis = new Position(a * Math.sin(p), b * Math.cos(q), b * Math.sin(q));
        return at -> {
            Position twice = axis.cross(at).times(2);
            return at.plus(twice.times(w)).plus(axis.cross(twice));
        };
    }
}
