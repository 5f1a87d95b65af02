using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Which of the declared classes are to be searched for. Allocates only when the command changes; for one thread.
/// </summary>
internal sealed class WantedClasses
{
    private readonly ImmutableArray<TargetClass> _declared;
    private ImmutableArray<TargetClassName> _names = [];
    private ImmutableArray<TargetClass> _selected;

    public WantedClasses(ImmutableArray<TargetClass> declared)
    {
        (_declared, _selected) = (declared, declared);
        MinSideMetres = MinSideOf(declared);
    }

    /// <summary>
    /// Side of the smallest target of the classes that were selected last, metres; of a marker, of a part that must be
    /// seen of it.
    /// </summary>
    public double MinSideMetres { get; private set; }

    /// <summary>Names of the last command that are not declared; null if all are.</summary>
    public string? Unknown { get; private set; }

    /// <summary>The declared classes of these names; all for none.</summary>
    public ImmutableArray<TargetClass> Select(ImmutableArray<TargetClassName> names)
    {
        if (names.IsDefault)
            names = [];
        if (names != _names)
            Change(names);
        return _selected;
    }

    // A method of its own, so that only a change allocates for the lambdas.
    private void Change(ImmutableArray<TargetClassName> names)
    {
        _names = names;
        _selected = names.IsEmpty ? _declared : _declared.Where(c => names.Contains(c.Name)).ToImmutableArray();
        MinSideMetres = MinSideOf(_selected);
        List<TargetClassName> unknown = names.Where(n => _declared.All(c => c.Name != n)).ToList();
        Unknown = unknown.Count == 0 ? null : string.Join(", ", unknown);
    }

    private static double MinSideOf(ImmutableArray<TargetClass> classes)
        => classes.IsEmpty ? double.PositiveInfinity : classes.Min(c => c.ResolvedSideMetres);
}
