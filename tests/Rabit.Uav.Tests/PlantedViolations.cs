using System;
using System.Collections.Generic;

// A small house with holes in its walls, so that a test can show that they are found.
namespace Rabit.Uav.Tests.Planted.Communications
{
    internal class Neighbour
    {
        public static int Count() => 1;
    }

    [AttributeUsage(AttributeTargets.Class)]
    internal sealed class NeighbourAttribute : Attribute;
}

namespace Rabit.Uav.Tests.Planted.Messages
{
    internal struct Posting
    {
        public int Number { get; set; }
    }

    internal sealed class ByMessage
    {
        public Communications.Neighbour? Sender { get; set; }
    }
}

namespace Rabit.Uav.Tests.Planted.MissionControl
{
    internal sealed class Innocent
    {
        public Messages.Posting Posting { get; set; }
    }

    internal sealed class ByField
    {
        public object Get() => _neighbour;

        private readonly Communications.Neighbour _neighbour = null!;
    }

    internal sealed class BySignature
    {
        public void Take(List<Communications.Neighbour[]> neighbours) => GC.KeepAlive(neighbours);
    }

    internal sealed class ByCall
    {
        public int Do() => Communications.Neighbour.Count();
    }

    internal sealed class ByLambda
    {
        public Func<int> Do(int more) => () => Communications.Neighbour.Count() + more;
    }

    internal sealed class ByLocal
    {
        public bool Do(object other) => other is Communications.Neighbour;
    }

    internal sealed class ByGenericArgument
    {
        public object Do() => Array.Empty<Communications.Neighbour>();
    }

    internal sealed class ByBase : Communications.Neighbour;

    [Communications.Neighbour]
    internal sealed class ByAttribute;
}
