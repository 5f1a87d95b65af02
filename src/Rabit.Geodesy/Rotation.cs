using System;

namespace Rabit.Geodesy;

/// <summary>
/// A rotation that takes the components of a vector in one frame to its components in another: as an attitude from the
/// body (forward-right-down) to north-east-down. What holds it says from where to where. A unit quaternion inside,
/// Hamilton's product. A plain value; the default value is no rotation at all, see <see cref="Identity"/>.
/// </summary>
/// <remarks>
/// Formulas: J. Diebel, "Representing attitude: Euler angles, unit quaternions, and rotation vectors", Stanford 2006.
/// </remarks>
/// <example>
/// <code>
/// Rotation attitude = Rotation.FromEuler(EulerAngles.FromDegrees(0, 10, 90));
/// NedVector nose = attitude.ToNed(new BodyVector(1, 0, 0));                    // east, a little up
/// Rotation turned = attitude.After(BodyRates.FromDegreesPerSecond(0, 0, 20), seconds: 0.5);
/// </code>
/// </example>
public readonly record struct Rotation
{
    // Below this angle the sine in SLERP has lost its digits, and a straight line is the arc.
    private const double NearlyEqual = 1 - 1e-12;

    private Rotation(double w, double x, double y, double z)
    {
        (W, X, Y, Z) = (w, x, y, z);
    }

    /// <summary>The one that changes nothing.</summary>
    public static Rotation Identity => new(1, 0, 0, 0);

    /// <summary>Scalar part of the unit quaternion; the quaternion and its negative are the same rotation.</summary>
    public double W { get; }

    /// <summary>First vector part.</summary>
    public double X { get; }

    /// <summary>Second vector part.</summary>
    public double Y { get; }

    /// <summary>Third vector part.</summary>
    public double Z { get; }

    /// <summary>The angle by which it turns, 0 to 180 degrees.</summary>
    public Angle Angle => Angle.FromRadians(2 * Math.Atan2(Math.Sqrt((X * X) + (Y * Y) + (Z * Z)), Math.Abs(W)));

    /// <summary>Whether it is one: not the default value, and a number.</summary>
    public bool IsValid => Math.Abs((W * W) + (X * X) + (Y * Y) + (Z * Z) - 1) < 1e-6;

    /// <summary>The way back.</summary>
    public Rotation Inverse => new(W, -X, -Y, -Z);

    /// <summary>One after the other: first <paramref name="b"/>, then <paramref name="a"/>.</summary>
    public static Rotation operator *(Rotation a, Rotation b) => new(
        (a.W * b.W) - (a.X * b.X) - (a.Y * b.Y) - (a.Z * b.Z),
        (a.W * b.X) + (a.X * b.W) + (a.Y * b.Z) - (a.Z * b.Y),
        (a.W * b.Y) - (a.X * b.Z) + (a.Y * b.W) + (a.Z * b.X),
        (a.W * b.Z) + (a.X * b.Y) - (a.Y * b.X) + (a.Z * b.W));

    /// <summary>From a quaternion, which is brought to unit length.</summary>
    /// <param name="w">Scalar part.</param>
    /// <param name="x">First vector part.</param>
    /// <param name="y">Second vector part.</param>
    /// <param name="z">Third vector part.</param>
    /// <exception cref="ArgumentException">It has no length, or is not a number.</exception>
    public static Rotation FromQuaternion(double w, double x, double y, double z)
    {
        double length = Math.Sqrt((w * w) + (x * x) + (y * y) + (z * z));
        if (!(length > 0) || double.IsInfinity(length))
            throw new ArgumentException(
                FormattableString.Invariant($"({w}, {x}, {y}, {z}) is not the quaternion of a rotation."), nameof(w));
        return new Rotation(w / length, x / length, y / length, z / length);
    }

    /// <summary>The attitude of a body: from forward-right-down to north-east-down.</summary>
    /// <param name="angles">Yaw, then pitch, then roll. Not a number stays so.</param>
    public static Rotation FromEuler(EulerAngles angles)
    {
        (double sinRoll, double cosRoll) = (Trig.Sin(angles.Roll.Radians / 2), Trig.Cos(angles.Roll.Radians / 2));
        (double sinPitch, double cosPitch) = (Trig.Sin(angles.Pitch.Radians / 2), Trig.Cos(angles.Pitch.Radians / 2));
        (double sinYaw, double cosYaw) = (Trig.Sin(angles.Yaw.Radians / 2), Trig.Cos(angles.Yaw.Radians / 2));
        return new Rotation(
            (cosRoll * cosPitch * cosYaw) + (sinRoll * sinPitch * sinYaw),
            (sinRoll * cosPitch * cosYaw) - (cosRoll * sinPitch * sinYaw),
            (cosRoll * sinPitch * cosYaw) + (sinRoll * cosPitch * sinYaw),
            (cosRoll * cosPitch * sinYaw) - (sinRoll * sinPitch * cosYaw));
    }

    /// <summary>From a rotation vector: about its direction, by its length.</summary>
    /// <param name="xRadians">First component.</param>
    /// <param name="yRadians">Second component.</param>
    /// <param name="zRadians">Third component.</param>
    public static Rotation FromRotationVector(double xRadians, double yRadians, double zRadians)
    {
        double angle = Math.Sqrt((xRadians * xRadians) + (yRadians * yRadians) + (zRadians * zRadians));
        double factor = angle < 1e-8 ? 0.5 : Trig.Sin(angle / 2) / angle;
        return new Rotation(Trig.Cos(angle / 2), xRadians * factor, yRadians * factor, zRadians * factor);
    }

    /// <summary>From a rotation matrix, row by row, as a calibration gives it.</summary>
    /// <param name="matrix">Nine numbers.</param>
    /// <exception cref="ArgumentException">
    /// It is not nine numbers, or not the matrix of a rotation within 1e-3.
    /// </exception>
    public static Rotation FromMatrix(params double[] matrix)
    {
        RotationMatrix.Demand(matrix ?? throw new ArgumentNullException(nameof(matrix)), nameof(matrix));
        (double w, double x, double y, double z) = RotationMatrix.ToQuaternion(matrix);
        return FromQuaternion(w, x, y, z);
    }

    /// <summary>Between two rotations, on the shortest arc and at an even rate (SLERP).</summary>
    /// <param name="from">At part 0.</param>
    /// <param name="to">At part 1.</param>
    /// <param name="part">0 to 1.</param>
    public static Rotation Slerp(Rotation from, Rotation to, double part)
    {
        double dot = (from.W * to.W) + (from.X * to.X) + (from.Y * to.Y) + (from.Z * to.Z);
        double sign = dot < 0 ? -1 : 1;
        dot = Math.Abs(dot);
        (double a, double b) = (1 - part, part);
        if (dot < NearlyEqual)
        {
            double angle = Math.Acos(dot);
            double sine = Trig.Sin(angle);
            (a, b) = (Trig.Sin(a * angle) / sine, Trig.Sin(b * angle) / sine);
        }

        b *= sign;
        return FromQuaternion(
            (a * from.W) + (b * to.W), (a * from.X) + (b * to.X), (a * from.Y) + (b * to.Y), (a * from.Z) + (b * to.Z));
    }

    /// <summary>As an attitude, what it is after turning at an even rate for a while.</summary>
    /// <param name="rates">In the body frame.</param>
    /// <param name="seconds">How long; negative for what it was before.</param>
    public Rotation After(BodyRates rates, double seconds) => this * FromRotationVector(
        rates.RollRadiansPerSecond * seconds, rates.PitchRadiansPerSecond * seconds,
        rates.YawRadiansPerSecond * seconds);

    /// <summary>
    /// As an attitude, its angles: roll and yaw from -pi to pi. With the nose straight up or down many pairs of roll
    /// and yaw are right; it is one of them.
    /// </summary>
    public EulerAngles ToEuler()
    {
        double sinPitch = 2 * ((W * Y) - (X * Z));
        double cosPitchSinRoll = 2 * ((Y * Z) + (W * X));
        double cosPitchCosRoll = 1 - (2 * ((X * X) + (Y * Y)));
        double cosPitch = Math.Sqrt((cosPitchSinRoll * cosPitchSinRoll) + (cosPitchCosRoll * cosPitchCosRoll));

        // The yaw that belongs to this roll, even where the roll is nothing but rounding.
        double roll = Math.Atan2(cosPitchSinRoll, cosPitchCosRoll);
        (double sinRoll, double cosRoll) = (Trig.Sin(roll), Trig.Cos(roll));
        double sinYaw = (2 * ((X * Z) + (W * Y)) * sinRoll) - (2 * ((X * Y) - (W * Z)) * cosRoll);
        double cosYaw = ((1 - (2 * ((X * X) + (Z * Z)))) * cosRoll) - (2 * ((Y * Z) - (W * X)) * sinRoll);
        return EulerAngles.FromRadians(roll, Math.Atan2(sinPitch, cosPitch), Math.Atan2(sinYaw, cosYaw));
    }

    /// <summary>As an attitude, a vector of the body in north-east-down.</summary>
    /// <param name="body">In any unit.</param>
    public NedVector ToNed(BodyVector body)
    {
        (double north, double east, double down) = Apply(body.Forward, body.Right, body.Down);
        return new NedVector(north, east, down);
    }

    /// <summary>As an attitude, a north-east-down vector in the body frame.</summary>
    /// <param name="ned">In any unit.</param>
    public BodyVector ToBody(NedVector ned)
    {
        (double forward, double right, double down) = Inverse.Apply(ned.North, ned.East, ned.Down);
        return new BodyVector(forward, right, down);
    }

    /// <summary>The components of a vector in the other frame.</summary>
    /// <param name="x">First component.</param>
    /// <param name="y">Second component.</param>
    /// <param name="z">Third component.</param>
    public (double X, double Y, double Z) Apply(double x, double y, double z)
    {
        // v + 2 w (q x v) + 2 q x (q x v)
        double tx = 2 * ((Y * z) - (Z * y));
        double ty = 2 * ((Z * x) - (X * z));
        double tz = 2 * ((X * y) - (Y * x));
        return (
            x + (W * tx) + (Y * tz) - (Z * ty),
            y + (W * ty) + (Z * tx) - (X * tz),
            z + (W * tz) + (X * ty) - (Y * tx));
    }

    /// <summary>As its quaternion, scalar part first.</summary>
    public override string ToString()
        => FormattableString.Invariant($"({W:0.######}; {X:0.######}, {Y:0.######}, {Z:0.######})");
}
