using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>Lanes around the middle of a convex area, ring in ring, one leg for each edge.</summary>
internal static class ContourCutter
{
    public static List<List<PlanePoint>> Cut(PlanePolygon area, double spacing, bool isEven)
    {
        double radius = InRadius(area);
        int rings = Math.Max(1, (int)Math.Ceiling((radius / spacing) - (isEven ? 1e-6 : 0.5)));
        double step = isEven ? radius / rings : Math.Min(spacing, radius / (rings - 0.49));
        var lanes = new List<List<PlanePoint>>();
        for (int k = 0; k < rings; k++)
        {
            List<PlanePoint> ring = Inset(area, (k + 0.5) * step);
            for (int i = 0; i < ring.Count; i++)
            {
                if (ring[i].DistanceTo(ring[(i + 1) % ring.Count]) > spacing / 100)
                    lanes.Add([ring[i], ring[(i + 1) % ring.Count]]);
            }
        }

        return lanes;
    }

    private static double InRadius(PlanePolygon area)
    {
        double low = 0;
        double high = Math.Sqrt(area.Area);
        for (int i = 0; i < 40; i++)
        {
            double middle = (low + high) / 2;
            (low, high) = Inset(area, middle).Count > 0 ? (middle, high) : (low, middle);
        }

        return low;
    }

    // The polygon cut by each edge moved inwards (Sutherland and Hodgman).
    private static List<PlanePoint> Inset(PlanePolygon area, double metres)
    {
        List<PlanePoint> rest = area.Corners.ToList();
        for (int i = 0; i < area.Corners.Count && rest.Count > 0; i++)
        {
            PlanePoint inwards = PlanePoint.Towards(area.NormalBefore(i, 0) + Math.PI);
            double limit = area.Corners[i].Dot(inwards) + metres;
            var kept = new List<PlanePoint>();
            for (int k = 0; k < rest.Count; k++)
            {
                PlanePoint a = rest[k];
                PlanePoint b = rest[(k + 1) % rest.Count];
                double da = a.Dot(inwards) - limit;
                double db = b.Dot(inwards) - limit;
                if (da >= 0)
                    kept.Add(a);
                if ((da >= 0) != (db >= 0))
                    kept.Add(a + (da / (da - db) * (b - a)));
            }

            rest = kept;
        }

        return rest;
    }
}
