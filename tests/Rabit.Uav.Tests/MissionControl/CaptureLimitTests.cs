using System;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>
/// What a vehicle with a camera that is fixed to it can capture at best: a car that comes the other way on a straight
/// road, whose velocity is known from when it is confirmed on. How long it is out of the picture until the vehicle is
/// over it; the table of docs/managers/mission-control.md.
/// </summary>
public sealed class CaptureLimitTests
{
    private const double SearchSpeed = 6;
    private const double FollowSpeed = 12;
    private const double Acceleration = 2.5;
    private const double HalfPictureMetres = 24;   // the longer side, from 40 m
    private const double HeightMetres = 40;
    private const double Drag = 0.2;               // 1/s, as the simulated vehicle
    private const double Gravity = 9.81;
    private const double Step = 0.01;

    [Theory]
    [InlineData(3, 1, 0)]
    [InlineData(3, 2, 0)]
    [InlineData(5, 1, 2.6)]
    [InlineData(5, 2, 5.2)]
    [InlineData(8, 0.5, 5.5)]
    [InlineData(8, 1, 8.0)]
    [InlineData(8, 2, 12.6)]
    public void Capture_CarThatComesTheOtherWay_IsOutOfThePictureForThatLong(
        double carSpeed, double confirmedAfter, double seconds)
        => Assert.Equal(seconds, SecondsOutOfView(carSpeed, confirmedAfter), 0.06);

    // Along the first way of the vehicle: it enters the picture ahead, and goes towards negative places.
    private static double SecondsOutOfView(double carSpeed, double confirmedAfter)
    {
        (double car, double velocity) = (HalfPictureMetres, SearchSpeed);
        (double unseen, double longest) = (0, 0);
        for (double time = 0; time < 60; time += Step)
        {
            bool isConfirmed = time >= confirmedAfter;
            double change = isConfirmed ? Limited(Wanted(car, carSpeed) - velocity, Acceleration * Step) : 0;
            velocity += change;
            car -= (carSpeed + velocity) * Step;

            // It leans the way it accelerates, and against the drag: the picture goes the other way.
            double lean = (change / Step) + (Drag * velocity);
            bool isInView = Math.Abs(car + (HeightMetres * lean / Gravity)) <= HalfPictureMetres;
            unseen = isInView || !isConfirmed ? 0 : unseen + Step;
            longest = Math.Max(longest, unseen);
            bool isOver = time > confirmedAfter + 1 && Math.Abs(car) < 8 && Math.Abs(velocity + carSpeed) < 3;
            if (isOver && isInView)
                return longest;
        }

        return double.PositiveInfinity;
    }

    // As fast as it may, and can still brake to the speed of the car over it.
    private static double Wanted(double car, double carSpeed) => car >= 0
        ? -carSpeed
        : -carSpeed - Math.Min(FollowSpeed - carSpeed, Math.Sqrt(2 * Acceleration * -car));

    private static double Limited(double value, double limit) => Math.Max(-limit, Math.Min(limit, value));
}
