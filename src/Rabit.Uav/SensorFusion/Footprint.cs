using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// The ground that a picture shows: a convex quadrangle in the plane of a local frame, metres. A plain value.
/// </summary>
internal readonly struct Footprint
{
    // A picture that shows more than this was not searched: the observation is wrong.
    private const double MaxSideMetres = 5000;

    private readonly double _n0, _e0, _n1, _e1, _n2, _e2, _n3, _e3;
    private readonly double _turn;

    private Footprint(NedPosition a, NedPosition b, NedPosition c, NedPosition d, double turn)
    {
        (_n0, _e0, _n1, _e1) = (a.North, a.East, b.North, b.East);
        (_n2, _e2, _n3, _e3) = (c.North, c.East, d.North, d.East);
        _turn = turn;
    }

    /// <summary>Whether there is one; one that shows nothing contains nothing.</summary>
    public bool IsKnown => _turn != 0;

    /// <summary>
    /// The footprint of an observation; an unknown one if its corners are not those of a picture of the ground.
    /// </summary>
    public static Footprint Of(in CameraObservation observation, in LocalNedFrame frame)
    {
        NedPosition a = frame.ToNed(observation.TopLeft);
        NedPosition b = frame.ToNed(observation.TopRight);
        NedPosition c = frame.ToNed(observation.BottomRight);
        NedPosition d = frame.ToNed(observation.BottomLeft);
        double turn = Turn(a, b, c);
        bool isConvex = turn > 0
            ? Turn(b, c, d) > 0 && Turn(c, d, a) > 0 && Turn(d, a, b) > 0
            : turn < 0 && Turn(b, c, d) < 0 && Turn(c, d, a) < 0 && Turn(d, a, b) < 0;
        bool isSmall = Side(a, b) < MaxSideMetres && Side(b, c) < MaxSideMetres && Side(c, d) < MaxSideMetres;
        return isConvex && isSmall ? new Footprint(a, b, c, d, Math.Sign(turn)) : default;
    }

    /// <summary>How much ground it is, square metres; 0 for an unknown one.</summary>
    public double AreaSquareMetres
        => Math.Abs(((_n2 - _n0) * (_e3 - _e1)) - ((_e2 - _e0) * (_n3 - _n1))) / 2;

    /// <summary>Whether a point is in it and no nearer to its border than a margin.</summary>
    public bool Contains(double north, double east, double marginMetres)
        => IsKnown
            && IsInside(_n0, _e0, _n1, _e1, north, east, marginMetres)
            && IsInside(_n1, _e1, _n2, _e2, north, east, marginMetres)
            && IsInside(_n2, _e2, _n3, _e3, north, east, marginMetres)
            && IsInside(_n3, _e3, _n0, _e0, north, east, marginMetres);

    private bool IsInside(double n0, double e0, double n1, double e1, double north, double east, double margin)
    {
        double dn = n1 - n0;
        double de = e1 - e0;
        double cross = (dn * (east - e0)) - (de * (north - n0));
        return cross * _turn >= margin * Math.Sqrt((dn * dn) + (de * de));
    }

    private static double Turn(NedPosition a, NedPosition b, NedPosition c)
        => ((b.North - a.North) * (c.East - b.East)) - ((b.East - a.East) * (c.North - b.North));

    private static double Side(NedPosition a, NedPosition b) => Math.Abs(a.North - b.North) + Math.Abs(a.East - b.East);
}
