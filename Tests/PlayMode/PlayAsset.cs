using System;
using UnityEngine;
using UnityEngine.SceneManagement;
#if UNITY_EDITOR
using UnityEditor;
using UnityEditor.SceneManagement;
#endif

namespace Glint.Tests
{
    /// <summary>Assets by path. Player builds lack them, so these tests run in the editor's play mode.</summary>
    static class PlayAsset
    {
        public static void LoadScene(string path)
        {
#if UNITY_EDITOR
            EditorSceneManager.LoadSceneInPlayMode(path, new LoadSceneParameters(LoadSceneMode.Single));
#else
            throw new NotSupportedException($"{path} is not part of a player: run these tests in the editor");
#endif
        }

        public static T Load<T>(string path) where T : UnityEngine.Object
        {
#if UNITY_EDITOR
            var asset = AssetDatabase.LoadAssetAtPath<T>(path);
            return asset != null ? asset : throw new InvalidOperationException($"{path} is missing");
#else
            throw new NotSupportedException($"{path} is not part of a player: run these tests in the editor");
#endif
        }

        public static string ReadText(string path) => Load<TextAsset>(path).text;
    }
}
