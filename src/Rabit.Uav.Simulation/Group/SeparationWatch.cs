using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Watches the true distances between vehicles: less than 30 m over ground and less than 15 m in height is too near,
/// but for a vehicle that is within 15 m of its own landing place; less than 1 m is a collision. One thread.
/// </summary>
internal sealed class SeparationWatch
{
    private const double HorizontalMetres = 30;
    private const double VerticalMetres = 15;
    private const double LandingPlaceMetres = 15;
    private const double CollisionMetres = 1;

    private readonly Dictionary<(int, int), Separation> _nearest = [];

    /// <summary>The nearest that each pair came to each other where that was too near.</summary>
    public IReadOnlyList<Separation> TooNear => _nearest.OrderBy(n => n.Key).Select(n => n.Value).ToArray();

    /// <summary>Those that met.</summary>
    public IReadOnlyList<Separation> Collisions
        => TooNear.Where(s => Math.Max(s.HorizontalMetres, s.VerticalMetres) < CollisionMetres).ToArray();

    public void Update(IReadOnlyList<SimulatedGroupVehicle> vehicles, TimeSpan now)
    {
        for (int i = 0; i < vehicles.Count; i++)
        {
            for (int j = i + 1; j < vehicles.Count; j++)
                Update((i, vehicles[i]), (j, vehicles[j]), now);
        }
    }

    private void Update(
        (int Number, SimulatedGroupVehicle Vehicle) a, (int Number, SimulatedGroupVehicle Vehicle) b, TimeSpan now)
    {
        NedPosition first = a.Vehicle.Place;
        NedPosition second = b.Vehicle.Place;
        bool areInTheAir = first.Down < 0 && second.Down < 0;
        double horizontal = first.HorizontalDistanceTo(second);
        double vertical = Math.Abs(first.Down - second.Down);
        if (!areInTheAir || horizontal >= HorizontalMetres || vertical >= VerticalMetres
            || IsAtHome(first, a.Vehicle) || IsAtHome(second, b.Vehicle))
            return;
        (int, int) pair = (a.Number, b.Number);
        if (!_nearest.TryGetValue(pair, out Separation? nearest)
            || Distance(horizontal, vertical) < Distance(nearest.HorizontalMetres, nearest.VerticalMetres))
            _nearest[pair] = new Separation(a.Number, b.Number, horizontal, vertical, now);
    }

    private static bool IsAtHome(NedPosition place, SimulatedGroupVehicle vehicle)
        => place.HorizontalDistanceTo(vehicle.Start) < LandingPlaceMetres;

    private static double Distance(double horizontal, double vertical)
        => Math.Sqrt((horizontal * horizontal) + (vertical * vertical));
}
