package org.dronewatch.drone;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.drone.silhouette.SilhouetteTable;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sound.Tone;
import org.jogamp.vecmath.Matrix4d;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;

/**
 * A drone at one instant: a mesh with its tree in model space, and the matrix that transforms the mesh to the world.
 * Moving a drone returns a new one, which has another matrix and shares the mesh. Immutable and thread-safe.
 *
 * <p>The model matrix is {@code M = T R S}: scale first, then rotate, then translate. Rotations are right-handed, like
 * vecmath's {@code rotX}, {@code rotY} and {@code rotZ}.
 */
public final class Drone {
    private static final double ROUNDING = 1e-9;

    private final String id;
    private final DroneSettings settings;
    private final DroneMesh mesh;
    private final Matrix4d modelMatrix;
    private final InverseMatrix worldToModel;
    private final Vector3d velocity;
    private final OptionalDouble gliding;

    /** A drone at rest at the origin of the world, with its nose to the north. */
    public Drone(String id, DroneSettings settings, KDTree tree) {
        this(id, settings, new TracingIndex(tree));
    }

    /**
     * A drone at rest at the origin of the world, with its nose to the north and an index of its mesh that other drones
     * may share.
     */
    public Drone(String id, DroneSettings settings, TracingIndex index) {
        this(id, settings, new DroneMesh(index), identity(), new Vector3d(), OptionalDouble.empty());
    }

    private Drone(
            String id,
            DroneSettings settings,
            DroneMesh mesh,
            Matrix4d modelMatrix,
            Vector3d velocity,
            OptionalDouble gliding) {
        this.id = id;
        this.settings = settings;
        this.mesh = mesh;
        this.modelMatrix = modelMatrix;
        this.velocity = velocity;
        this.gliding = gliding;
        if (!(Math.abs(modelMatrix.determinant()) > 0.0)) {
            throw new IllegalArgumentException("model matrix of drone '" + id + "' must be invertible: " + modelMatrix);
        }
        this.worldToModel = new InverseMatrix(modelMatrix);
    }

    /**
     * This drone rotated about its own x axis (to its right) at a rate in rad/s for dt seconds: {@code M' = M rotX(rate
     * dt)}.
     */
    public Drone rotateX(double rate, double dt) {
        Matrix4d turn = new Matrix4d();
        turn.rotX(rate * dt);
        return turned(turn);
    }

    /** This drone rotated about its own y axis (towards its nose) at a rate in rad/s for dt seconds. */
    public Drone rotateY(double rate, double dt) {
        Matrix4d turn = new Matrix4d();
        turn.rotY(rate * dt);
        return turned(turn);
    }

    /**
     * This drone rotated about its own z axis (up) at a rate in rad/s for dt seconds, counter-clockwise as seen from
     * above.
     */
    public Drone rotateZ(double rate, double dt) {
        Matrix4d turn = new Matrix4d();
        turn.rotZ(rate * dt);
        return turned(turn);
    }

    private Drone turned(Matrix4d turn) {
        Matrix4d next = new Matrix4d();
        next.mul(modelMatrix, turn);
        return new Drone(id, settings, mesh, next, velocity, gliding);
    }

    /** This drone displaced by a vector in the world, m; its velocity is unchanged. */
    public Drone move(Vector3d displacement) {
        Matrix4d next = new Matrix4d(modelMatrix);
        next.m03 += displacement.x;
        next.m13 += displacement.y;
        next.m23 += displacement.z;
        return new Drone(id, settings, mesh, next, velocity, gliding);
    }

    /**
     * This drone in a given state of its flight: at that position, with that velocity and its motors running or not,
     * its model unscaled and rotated by the {@link Attitude}.
     */
    public Drone at(FlightState state) {
        Attitude attitude = state.attitude();
        Matrix4d pose = new Matrix4d();
        pose.rotZ(-attitude.yaw());
        if (!attitude.isLevel()) {
            Matrix4d turn = new Matrix4d();
            turn.rotX(attitude.pitch());
            pose.mul(turn);
            turn.rotY(attitude.roll());
            pose.mul(turn);
        }
        pose.setTranslation(state.position().toVector3d());
        return new Drone(id, settings, mesh, pose, state.velocity().toVector3d(), state.gliding());
    }

    /**
     * This drone with another model matrix.
     *
     * @throws IllegalArgumentException when the matrix cannot be inverted
     */
    public Drone withModelMatrix(Matrix4d matrix) {
        return new Drone(id, settings, mesh, new Matrix4d(matrix), velocity, gliding);
    }

    /** The drone's name in the scene. */
    public String id() {
        return id;
    }

    /** The settings from which the drone was created. */
    public DroneSettings settings() {
        return settings;
    }

    /** The tree over the drone's mesh, in model space. */
    public KDTree tree() {
        return mesh.index().tree();
    }

    /**
     * A new ray tracer of the drone's mesh, in model space, for use by one thread. It is intended for rays that start
     * many times the drone's size away.
     */
    public RayTracer newRayTracer() {
        return mesh.index().newIncoherentRayTracer();
    }

    /** The silhouettes of the drone's model when it is level; computed when first needed, and shared by all copies. */
    public SilhouetteTable silhouettes() {
        return mesh.silhouettes();
    }

    /** The box around the drone's mesh, in model space, m. */
    public AABB modelBounds() {
        return tree().bounds();
    }

    /** A copy of the matrix from model space to the world. */
    public Matrix4d modelMatrix() {
        return new Matrix4d(modelMatrix);
    }

    /** Writes the matrix from model space to the world. */
    public void modelMatrix(Matrix4d target) {
        target.set(modelMatrix);
    }

    /** Writes the matrix from the world to model space. */
    public void worldToModel(Matrix4d target) {
        target.set(worldToModel.get());
    }

    /** A copy of the matrix from the world to model space. */
    public Matrix4d worldToModel() {
        return new Matrix4d(worldToModel.get());
    }

    /** The position of the drone's origin in the world, m. */
    public Point3d position() {
        return new Point3d(modelMatrix.m03, modelMatrix.m13, modelMatrix.m23);
    }

    /** The position of the drone's origin in the world, m: {@link #position()} as an immutable value. */
    public Position origin() {
        return new Position(modelMatrix.m03, modelMatrix.m13, modelMatrix.m23);
    }

    /** The position in the world of a point of the drone's model, m. */
    public Position toWorld(Position point) {
        return transformed(modelMatrix, point);
    }

    /** The position in model space of a point of the world, m. */
    public Position toModel(Position point) {
        return transformed(worldToModel.get(), point);
    }

    private static Position transformed(Matrix4d m, Position point) {
        double x = point.x();
        double y = point.y();
        double z = point.z();
        return new Position(
                m.m00 * x + m.m01 * y + m.m02 * z + m.m03,
                m.m10 * x + m.m11 * y + m.m12 * z + m.m13,
                m.m20 * x + m.m21 * y + m.m22 * z + m.m23);
    }

    /**
     * An upper bound on the distance of any point of the drone's mesh from the drone's origin, m: the same at all
     * attitudes, and exact (except for rounding) unless its model is scaled non-uniformly.
     */
    public double radius() {
        return mesh.radius() * stretch(modelMatrix);
    }

    /**
     * The greatest factor by which a matrix can lengthen a vector: the square root of a bound on the largest eigenvalue
     * of its transpose times itself (Gershgorin). For a rotation, it is the same number regardless of rounding.
     */
    private static double stretch(Matrix4d m) {
        double xx = m.m00 * m.m00 + m.m10 * m.m10 + m.m20 * m.m20;
        double yy = m.m01 * m.m01 + m.m11 * m.m11 + m.m21 * m.m21;
        double zz = m.m02 * m.m02 + m.m12 * m.m12 + m.m22 * m.m22;
        double xy = Math.abs(m.m00 * m.m01 + m.m10 * m.m11 + m.m20 * m.m21);
        double xz = Math.abs(m.m00 * m.m02 + m.m10 * m.m12 + m.m20 * m.m22);
        double yz = Math.abs(m.m01 * m.m02 + m.m11 * m.m12 + m.m21 * m.m22);
        double most = Math.max(xx + xy + xz, Math.max(yy + xy + yz, zz + xz + yz));
        return Math.abs(most - 1.0) < ROUNDING ? 1.0 + ROUNDING : Math.sqrt(most) * (1.0 + ROUNDING);
    }

    /** A copy of the drone's velocity, m/s. */
    public Vector3d velocity() {
        return new Vector3d(velocity);
    }

    /** Whether the drone's motors run. */
    public boolean isPowered() {
        return gliding.isEmpty();
    }

    /** The drone's source level in its present state of flight, dB on the calibrated scale of the level model. */
    public double soundLevel() {
        return settings.emission().soundLevel(this);
    }

    /** The drone's sound power levels by octave band in its present state of flight, without weighting, dB re 1 pW. */
    public List<Double> soundPower() {
        return Arrays.stream(settings.emission().soundPower(this).toArray())
                .boxed()
                .toList();
    }

    /** The tones in the drone's sound in its present state of flight. */
    public List<Tone> tones() {
        return settings.emission().tones(this);
    }

    /**
     * The drone's apparent temperature difference from the background in its present state of flight, K; this
     * difference decays while the motors are off.
     */
    public double heat() {
        return settings.heat().after(gliding.orElse(0.0));
    }

    /** The distance from a point to the drone's origin, m. */
    public double distance(Position point) {
        return origin().distance(point);
    }

    private static Matrix4d identity() {
        Matrix4d identity = new Matrix4d();
        identity.setIdentity();
        return identity;
    }
}
