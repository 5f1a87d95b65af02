using System;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Markers;

public sealed class MarkerPoseSolverTests(ITestOutputHelper output)
{
    private const double Side = 0.5;

    [Fact]
    public void TrySolve_CornersWithoutNoise_GivesThePose()
    {
        var numbers = new SeededNumbers(3);
        for (int i = 0; i < 2_000; i++)
        {
            Scene scene = new(numbers);
            Assert.True(MarkerPoseSolver.TrySolve(scene.Rays, Side, 1e-3, out MarkerPose best, out MarkerPose other));
            Assert.True(best.ChiSquare < 1e-6 && best.ChiSquare <= other.ChiSquare, $"seed 3, {i}");
            Assert.True(scene.Off(best) < 1e-4 * scene.Distance, $"seed 3, {i}: {scene.Off(best)} m off");
            Assert.True(scene.AngleOff(best) < 1e-3, $"seed 3, {i}: {scene.AngleOff(best)} rad off");
        }
    }

    // Of 2 degrees of freedom 2 in the mean; of position 3; with noise of a third of a pixel at 900 of focal length.
    [Fact]
    public void TrySolve_CornersWithNoise_StatesItsErrors()
    {
        const double Sigma = 0.33 / 900;
        var numbers = new SeededNumbers(4);
        (double chi, double x, double z) = (0, 0, 0);
        (int ambiguous, int rightOfClear, int clear) = (0, 0, 0);
        const int Count = 4_000;
        for (int i = 0; i < Count; i++)
        {
            Scene scene = new(numbers);
            scene.AddNoise(numbers, Sigma);
            Assert.True(MarkerPoseSolver.TrySolve(scene.Rays, Side, Sigma, out MarkerPose best, out MarkerPose other));
            chi += Math.Min(20, best.ChiSquare);
            x += Math.Pow((best.X - scene.X) / best.SigmaX, 2);
            z += Math.Pow((best.Z - scene.Z) / best.SigmaZ, 2);
            if (MarkerPoseSolver.IsAmbiguous(best, other))
            {
                ambiguous++;
                continue;
            }

            clear++;
            rightOfClear += scene.AngleOff(best) < (4 * best.SigmaTilt) + 0.02 ? 1 : 0;
        }

        output.WriteLine(FormattableString.Invariant(
            $"chi square {chi / Count:0.00}; squares by sigma: x {x / Count:0.00}, z {z / Count:0.00}; {ambiguous} ambiguous; {rightOfClear} of {clear} others right"));
        Assert.InRange(chi / Count, 1.5, 2.5);
        Assert.InRange(x / Count, 0.7, 1.4);
        Assert.InRange(z / Count, 0.7, 1.6);
        Assert.InRange(ambiguous, 1, Count - 1);
        Assert.True(rightOfClear >= 0.97 * clear, $"{rightOfClear} of {clear}");
    }

    [Fact]
    public void TrySolve_FromTheFront_IsNotAmbiguous()
    {
        PicturePoint[] rays = [new(-0.05, -0.05), new(0.05, -0.05), new(0.05, 0.05), new(-0.05, 0.05)];
        Assert.True(MarkerPoseSolver.TrySolve(rays, Side, 1e-3, out MarkerPose best, out MarkerPose other));
        Assert.False(MarkerPoseSolver.IsAmbiguous(best, other));
        Assert.Equal(5, best.Z, 6);
        Assert.Equal(5, best.Distance, 6);
        Assert.Equal(1, best.RotationW, 6);
    }

    [Fact]
    public void TrySolve_NoSquare_IsRefused()
    {
        PicturePoint[] mirrored = [new(0.05, -0.05), new(-0.05, -0.05), new(-0.05, 0.05), new(0.05, 0.05)];
        Assert.False(MarkerPoseSolver.TrySolve(mirrored, Side, 1e-3, out _, out _));
        PicturePoint[] line = [new(0, 0), new(1, 0), new(2, 0), new(3, 0)];
        Assert.False(MarkerPoseSolver.TrySolve(line, Side, 1e-3, out _, out _));
    }

    [Theory]
    [InlineData(3, 0.5, 1e-3)]
    [InlineData(4, 0, 1e-3)]
    [InlineData(4, double.NaN, 1e-3)]
    [InlineData(4, 0.5, 0)]
    public void TrySolve_BadArgument_Throws(int corners, double side, double sigma)
        => Assert.Throws<ArgumentException>(
            () => MarkerPoseSolver.TrySolve(new PicturePoint[corners], side, sigma, out _, out _));

    // A marker somewhere in front of the camera, tilted by at most 54 degrees, so that its front is seen.
    private sealed class Scene
    {
        private readonly double[] _axisX;
        private readonly double[] _axisY;

        public Scene(SeededNumbers numbers)
        {
            Z = numbers.Uniform(2, 12);
            X = Z * numbers.Uniform(-0.4, 0.4);
            Y = Z * numbers.Uniform(-0.4, 0.4);
            double tilt = numbers.Uniform(0.05, 0.95);
            double about = numbers.Uniform(0, 2 * Math.PI);
            double turn = numbers.Uniform(0, 2 * Math.PI);
            _axisX = Turned([Math.Cos(turn), Math.Sin(turn), 0], about, tilt);
            _axisY = Turned([-Math.Sin(turn), Math.Cos(turn), 0], about, tilt);
            for (int i = 0; i < 4; i++)
            {
                double u = i is 1 or 2 ? Side / 2 : -Side / 2;
                double v = i >= 2 ? Side / 2 : -Side / 2;
                double z = Z + (u * _axisX[2]) + (v * _axisY[2]);
                Rays[i] = new PicturePoint(
                    (X + (u * _axisX[0]) + (v * _axisY[0])) / z, (Y + (u * _axisX[1]) + (v * _axisY[1])) / z);
            }
        }

        public double X { get; }

        public double Y { get; }

        public double Z { get; }

        public PicturePoint[] Rays { get; } = new PicturePoint[4];

        public double Distance => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));

        public void AddNoise(SeededNumbers numbers, double sigma)
        {
            for (int i = 0; i < 4; i++)
                Rays[i] = new PicturePoint(
                    Rays[i].X + (sigma * numbers.Gauss()), Rays[i].Y + (sigma * numbers.Gauss()));
        }

        public double Off(MarkerPose pose) => Math.Sqrt(
            Math.Pow(pose.X - X, 2) + Math.Pow(pose.Y - Y, 2) + Math.Pow(pose.Z - Z, 2));

        // Between the axes x and y of both.
        public double AngleOff(MarkerPose p)
        {
            double[] x =
            [
                1 - (2 * ((p.RotationY * p.RotationY) + (p.RotationZ * p.RotationZ))),
                2 * ((p.RotationX * p.RotationY) + (p.RotationW * p.RotationZ)),
                2 * ((p.RotationX * p.RotationZ) - (p.RotationW * p.RotationY)),
            ];
            double[] y =
            [
                2 * ((p.RotationX * p.RotationY) - (p.RotationW * p.RotationZ)),
                1 - (2 * ((p.RotationX * p.RotationX) + (p.RotationZ * p.RotationZ))),
                2 * ((p.RotationY * p.RotationZ) + (p.RotationW * p.RotationX)),
            ];
            return Math.Max(Between(x, _axisX), Between(y, _axisY));
        }

        private static double Between(double[] a, double[] b)
            => Math.Sqrt(Math.Pow(a[0] - b[0], 2) + Math.Pow(a[1] - b[1], 2) + Math.Pow(a[2] - b[2], 2));

        // About a direction in the plane of the picture (Rodrigues).
        private static double[] Turned(double[] v, double about, double angle)
        {
            (double kx, double ky) = (Math.Cos(about), Math.Sin(about));
            (double sin, double cos) = (Math.Sin(angle), Math.Cos(angle));
            double along = (1 - cos) * ((kx * v[0]) + (ky * v[1]));
            return
            [
                (v[0] * cos) + (sin * ky * v[2]) + (along * kx),
                (v[1] * cos) - (sin * kx * v[2]) + (along * ky),
                (v[2] * cos) + (sin * ((kx * v[1]) - (ky * v[0]))),
            ];
        }
    }
}
