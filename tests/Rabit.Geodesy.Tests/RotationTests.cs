using System;
using System.Linq;
using System.Text.Json;
using Xunit;

namespace Rabit.Geodesy.Tests;

public sealed class RotationTests
{
    private const double Tolerance = 1e-12;

    [Fact]
    public void FromEuler_Vectors_GivesTheirQuaternionMatrixAndVector()
    {
        foreach (JsonElement c in Vectors.Attitude.Each("cases"))
        {
            Rotation rotation = Rotation.FromEuler(c.Euler());
            AssertSame(c.Numbers("q"), rotation, Tolerance);
            AssertMatrix(c.Numbers("dcm"), rotation, Tolerance);

            double[] body = c.Numbers("v_body");
            NedVector ned = rotation.ToNed(new BodyVector(body[0], body[1], body[2]));
            AssertClose(c.Numbers("v_ned"), [ned.North, ned.East, ned.Down], 1e-11);
            BodyVector back = rotation.ToBody(ned);
            AssertClose(body, [back.Forward, back.Right, back.Down], 1e-11);
        }
    }

    [Fact]
    public void ToEuler_Vectors_GivesTheAnglesOrAtLeastTheMatrixBack()
    {
        foreach (JsonElement c in Vectors.Attitude.Each("cases"))
        {
            EulerAngles angles = Rotation.FromEuler(c.Euler()).ToEuler();
            AssertMatrix(c.Numbers("dcm"), Rotation.FromEuler(angles), 1e-11);
            if (c.TryGetProperty("euler_not_unique", out _) || Math.Abs(Math.Cos(c.Radians("pitch"))) < 0.01
                || Math.Abs(c.Number("pitch")) > 90)
                continue;
            Assert.Equal(0, Wrapped(angles.Roll.Radians - c.Radians("roll")), 1e-10);
            Assert.Equal(0, angles.Pitch.Radians - c.Radians("pitch"), 1e-10);
            Assert.Equal(0, Wrapped(angles.Yaw.Radians - c.Radians("yaw")), 1e-10);
        }
    }

    [Fact]
    public void FromMatrix_Vectors_GivesTheirQuaternion()
    {
        foreach (JsonElement c in Vectors.Attitude.Each("cases"))
            AssertSame(c.Numbers("q"), Rotation.FromMatrix(c.Numbers("dcm")), 1e-9);
    }

    [Fact]
    public void Multiply_Vectors_AgreesAndTheAngleBetweenToo()
    {
        foreach (JsonElement c in Vectors.Attitude.Each("multiply"))
        {
            Rotation a = Quaternion(c.Numbers("q1"));
            Rotation b = Quaternion(c.Numbers("q2"));
            AssertSame(c.Numbers("q1q2"), a * b, Tolerance);
            AssertSame(c.Numbers("q1_conj_q2"), a.Inverse * b, Tolerance);
            Assert.Equal(c.Radians("angle_deg"), (a.Inverse * b).Angle.Radians, 1e-10);
        }
    }

    [Fact]
    public void Slerp_Vectors_TakesTheShortArc()
    {
        foreach (JsonElement c in Vectors.Attitude.Each("slerp"))
            AssertSame(
                c.Numbers("q"), Rotation.Slerp(Quaternion(c.Numbers("q0")), Quaternion(c.Numbers("q1")), c.Number("t")),
                1e-10);
    }

    [Fact]
    public void Slerp_YawAcrossSouthOrNorth_DoesNotGoTheLongWay()
    {
        foreach (JsonElement c in Vectors.Attitude.Each("slerp_euler_wrap"))
        {
            Rotation at = Rotation.Slerp(Euler(c.Numbers("rpy0")), Euler(c.Numbers("rpy1")), c.Number("t"));
            AssertSame(c.Numbers("q"), at, 1e-10);
            EulerAngles angles = at.ToEuler();
            double[] expected = c.Numbers("rpy");
            Assert.Equal(0, Wrapped(angles.Yaw.Radians - (expected[2] * Vectors.Degree)), 1e-10);
        }
    }

    [Fact]
    public void After_Vectors_IntegratesBodyRates()
    {
        foreach (JsonElement c in Vectors.Attitude.Each("integrate"))
        {
            double[] w = c.Numbers("omega_body");
            AssertSame(
                c.Numbers("q1"),
                Quaternion(c.Numbers("q0")).After(BodyRates.FromRadiansPerSecond(w[0], w[1], w[2]), c.Number("dt")),
                Tolerance);
        }
    }

    [Fact]
    public void From_WhatIsNoRotation_IsRefused()
    {
        Assert.Throws<ArgumentException>(() => Rotation.FromQuaternion(0, 0, 0, 0));
        Assert.Throws<ArgumentException>(() => Rotation.FromQuaternion(double.NaN, 0, 0, 1));
        Assert.Contains(
            "9 numbers", Assert.Throws<ArgumentException>(() => Rotation.FromMatrix(1, 0, 0)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "rows 1 and 2",
            Assert.Throws<ArgumentException>(() => Rotation.FromMatrix(1, 0, 0, 1, 0, 0, 0, 0, 1)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "mirrors", Assert.Throws<ArgumentException>(() => Rotation.FromMatrix(0, 1, 0, 1, 0, 0, 0, 0, 1)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "length 1",
            Assert.Throws<ArgumentException>(() => Rotation.FromMatrix(1, 0, 0, 0, double.NaN, 0, 0, 0, 1)).Message,
            StringComparison.Ordinal);
    }

    private static Rotation Quaternion(double[] q) => Rotation.FromQuaternion(q[0], q[1], q[2], q[3]);

    private static Rotation Euler(double[] rpy)
        => Rotation.FromEuler(EulerAngles.FromDegrees(rpy[0], rpy[1], rpy[2]));

    private static double Wrapped(double radians) => Math.IEEERemainder(radians, 2 * Math.PI);

    // A quaternion and its negative are the same rotation.
    private static void AssertSame(double[] expected, Rotation actual, double tolerance)
    {
        double[] q = [actual.W, actual.X, actual.Y, actual.Z];
        double sign = expected.Zip(q, (a, b) => a * b).Sum() < 0 ? -1 : 1;
        AssertClose(expected, q.Select(v => v * sign).ToArray(), tolerance);
    }

    private static void AssertMatrix(double[] expected, Rotation rotation, double tolerance)
    {
        (double X, double Y, double Z)[] columns =
            [rotation.Apply(1, 0, 0), rotation.Apply(0, 1, 0), rotation.Apply(0, 0, 1)];
        AssertClose(
            expected,
            [.. columns.Select(c => c.X), .. columns.Select(c => c.Y), .. columns.Select(c => c.Z)],
            tolerance);
    }

    private static void AssertClose(double[] expected, double[] actual, double tolerance)
    {
        Assert.Equal(expected.Length, actual.Length);
        for (int i = 0; i < expected.Length; i++)
            Assert.True(Math.Abs(expected[i] - actual[i]) <= tolerance, $"[{i}] is {actual[i]:R}, not {expected[i]:R}");
    }
}
