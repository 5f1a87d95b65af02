namespace Rabit.Geodesy;

/// <summary>What a <see cref="TerrainGrid"/> knows of a place.</summary>
public enum TerrainLookup
{
    /// <summary>Its altitude.</summary>
    Known,

    /// <summary>The place is outside the grid.</summary>
    Outside,

    /// <summary>A corner of the cell around the place has no altitude.</summary>
    NoData,
}
