using System;
using Rabit.Core;
using Rabit.Diagnostics.Protocol;
using Rabit.Diagnostics.Values;

namespace Rabit.Diagnostics.Observing;

/// <summary>Reads the stamp of one message, and not its value.</summary>
internal sealed class MessageProbe(MessageObserver message)
{
    private readonly string _type = TypeText.Of(message.ValueType);
    private uint _lastPosts;

    public MessageFigures Read(Elapsed? elapsed, TimeSpan now)
    {
        MessageStamp stamp = message.ReadStamp();
        uint posts = unchecked((uint)stamp.Version);
        double? rate = elapsed?.Rate(unchecked(posts - _lastPosts));
        _lastPosts = posts;
        return new MessageFigures
        {
            Name = message.Name,
            ValueType = _type,
            Posts = posts,
            PostsPerSecond = rate,
            AgeSeconds = posts == 0 ? null : (now - stamp.Time).TotalSeconds,
        };
    }
}
